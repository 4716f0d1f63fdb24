/// Pictures in memory and in files (OpenImageIO behind image_io.cpp, the only file that sees it).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// Row-major from the top, linear values.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

/// One named layer of an EXR: "" is the default R,G,B; "direct" gives direct.R, direct.G, direct.B.
struct ImageLayer {
  std::string name;
  std::span<const Rgb> pixels;
};

/// Reads the default R,G,B of an EXR or HDR (linear) or a PNG (sRGB, decoded to linear). InputError if unreadable or truncated.
Image read_image(const std::filesystem::path& file);
/// Scanline float EXR with layers and header metadata; written beside, then renamed. InputError if unwritable.
void write_exr(const std::filesystem::path& file, int width, int height, std::span<const ImageLayer> layers,
               std::span<const std::pair<std::string, std::string>> header = {});
/// 8-bit sRGB PNG of linear values, clamped to [0, 1].
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace gibench
