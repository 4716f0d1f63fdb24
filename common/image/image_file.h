/// Pictures in files. OpenImageIO is a plugin beside the program that the first read or write loads
/// (image_plugin.h): it costs 200–300 ms and 131 MB, which a run without pictures does not pay.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/image/image.h"

namespace gibench {

/// One named layer of an EXR: "" is the default R,G,B; "direct" gives direct.R, direct.G, direct.B.
struct ImageLayer {
  std::string name;
  std::span<const Rgb> pixels;
};

/// A picture with what its file says of it.
struct ImageFile {
  Image image;
  bool high_dynamic_range = false;            ///< floating-point samples (EXR, HDR): linear as stored, no upper end
  std::map<std::string, std::string> header;  ///< the file's text attributes
  std::vector<std::string> warnings = {};     ///< what of the file was not read

  /// Whether it holds the six faces of a cube, as its header says.
  bool is_cube_map() const;
};

/// Reads the default R,G,B of an EXR or HDR (linear) or a PNG or JPEG of 8 or 16 bits (sRGB, decoded to linear; a PNG by the
/// gamma and the chromaticities that it states; a warning names an ICC profile, which is not applied). Grey becomes three equal
/// channels; alpha is ignored, the colours stay as stored. An EXR gives its display window, black where the file has no data, and
/// of several parts the one with R, G, B. Colours of other primaries, as an EXR or HDR states them, become those of Rec. 709; the
/// exposure of an HDR is taken out again. InputError if the file is missing, unreadable, truncated, has no colours, or has
/// luminance and chroma instead.
Image read_image(const std::filesystem::path& file);
/// The same with the header. A `layer` other than "" asks for LAYER.R, LAYER.G, LAYER.B of an EXR.
ImageFile read_image_file(const std::filesystem::path& file, const std::string& layer = {});
/// Scanline float EXR with layers and header metadata; written beside, then renamed. InputError if unwritable.
void write_exr(const std::filesystem::path& file, int width, int height, std::span<const ImageLayer> layers,
               std::span<const std::pair<std::string, std::string>> header = {});
/// 8-bit sRGB PNG of linear values, clamped to [0, 1]; a NaN becomes 0.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace gibench
