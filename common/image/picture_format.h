/// The format of a picture by its first bytes, so that a reader sees files of its own format only.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gibench {

/// OpenImageIO's name of the format ("openexr", "png"), empty for formats that gibench does not read. A Targa picture has
/// no mark of its own: its `name` decides.
std::string picture_format(std::string_view bytes, const std::filesystem::path& name);

}  // namespace gibench
