/// The named layers of an EXR.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/image/image.h"

namespace gibench {

/// Every complete R,G,B layer of an EXR by its name; "" is the default one. Other channels (Z, a lone alpha) are left
/// out. Throws InputError where the file cannot be read or is truncated.
std::map<std::string, Image> read_exr_layers(const std::filesystem::path& file);

}  // namespace gibench
