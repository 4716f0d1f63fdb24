/// The texels of a picture that a surface wears.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// One linear colour, not multiplied by its opacity, which is in [0, 1].
struct Texel {
  Rgb colour;
  float opacity = 1.0F;
};

/// Row-major from the top.
struct PictureTexels {
  int width = 0, height = 0;
  std::vector<Texel> texels;
  std::vector<std::string> remarks = {};  ///< what of the file was not read
};

/// The meaning of the levels of an 8- or 16-bit picture.
enum class TexelValues {
  colour,  ///< decoded to linear: from sRGB where the file states no other colour space
  srgb,    ///< decoded from sRGB whatever the file states
  data     ///< numbers as they stand, such as roughness or opacity; an alpha channel is not taken for opacity
};

/// Reads a picture of any format that image_file.h names; grey becomes three equal channels. InputError if it cannot be
/// read, has no colours, or a texel is not finite.
PictureTexels read_texels(const std::filesystem::path& file, TexelValues values = TexelValues::colour);
/// The same from a file's bytes in memory; `name` is what messages call it.
PictureTexels read_texels(std::string_view bytes, const std::string& name, TexelValues values = TexelValues::colour);

}  // namespace gibench
