#include "common/image/image_plugin.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "common/core/data_folder.h"
#include "common/core/error.h"

namespace gibench {

namespace {

/// Beside the program, as in the build folder, or in ../lib/gibench, as in an installed tree.
std::filesystem::path plugin_file() {
  std::filesystem::path beside = program_folder() / image_plugin_file;
  std::error_code unreadable;
  if (std::filesystem::exists(beside, unreadable)) return beside;
  return (program_folder() / "../lib/gibench" / image_plugin_file).lexically_normal();
}

/// Never unloaded: libraries behind OpenImageIO leave work for the end of the process.
const ImagePluginFunctions* load_plugin() {
  const std::filesystem::path file = plugin_file();
  std::error_code unreadable;
  if (!std::filesystem::exists(file, unreadable))
    throw InputError(file.string(), "the image plugin is missing",
                     "keep it in bin/ or lib/gibench/ of the program's tree, or build the whole project");
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
