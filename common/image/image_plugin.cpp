#include "common/image/image_plugin.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "common/core/error.h"

namespace gibench {

namespace {

/// Never unloaded: libraries behind OpenImageIO leave work for the end of the process.
const ImagePluginFunctions* load_plugin() {
  const std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe").parent_path() / image_plugin_file;
  std::error_code unreadable;
  if (!std::filesystem::exists(file, unreadable))
    throw InputError(file.string(), "the image plugin is missing",
                     "keep it in the folder of the program, or build the whole project");
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = dlerror();
    throw InputError(file.string(), std::string("the image plugin cannot be loaded (") + (reason == nullptr ? "?" : reason) + ")",
                     "install OpenImageIO and build the project again");
  }
  const auto entry = reinterpret_cast<ImagePluginEntry>(dlsym(library, image_plugin_symbol));
  if (entry == nullptr) throw InputError(file.string(), "is not gibench's image plugin", "build the project again");
  return entry();
}

}  // namespace

const ImagePluginFunctions& image_plugin() {
  static const ImagePluginFunctions* const functions = load_plugin();
  return *functions;
}

}  // namespace gibench
