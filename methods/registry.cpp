#include "methods/registry.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "common/core/error.h"
#include "common/core/names.h"
#include "methods/antiradiance/antiradiance.h"
#include "methods/meshless/meshless.h"
#include "methods/pathtracer/pathtracer.h"
#include "methods/spectral/spectral.h"
#include "methods/wavelet/wavelet.h"

namespace gibench {

namespace {

std::vector<MethodEntry>& registry() {
  static std::vector<MethodEntry> methods{
      pathtracer_entry(), meshless_entry(), spectral_entry(), antiradiance_entry(), wavelet_entry(),
  };
  return methods;
}

}  // namespace

std::span<const MethodEntry> all_methods() { return registry(); }

void add_method(MethodEntry entry) {
  for (const MethodEntry& known : registry())
    if (known.name == entry.name)
      throw InputError("the program's own methods", fmt::format("'{}' is there already", entry.name), "choose another name");
  registry().push_back(std::move(entry));
}

const MethodEntry& find_method(std::string_view name, const std::string& place) {
  std::vector<std::string> names;
  for (const MethodEntry& entry : all_methods()) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw InputError(place, fmt::format("unknown method '{}'", name), known_names("known", name, names));
}

}  // namespace gibench
