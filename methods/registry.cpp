#include "methods/registry.h"

#include <fmt/format.h>

#include <vector>

#include "common/core/error.h"
#include "common/core/names.h"
#include "methods/antiradiance/antiradiance.h"
#include "methods/meshless/meshless.h"
#include "methods/pathtracer/pathtracer.h"
#include "methods/spectral/spectral.h"

namespace gibench {

std::span<const MethodEntry> all_methods() {
  static const std::vector<MethodEntry> methods{
      pathtracer_entry(),
      meshless_entry(),
      spectral_entry(),
      antiradiance_entry(),
  };
  return methods;
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
