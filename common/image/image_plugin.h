/// The seam between the program and the image plugin (plugin/openimageio.cpp): a table of functions that throw
/// nothing, found by name in the shared library gibench_image_plugin.so.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/image/primaries.h"

namespace gibench {

/// What a file holds, before any meaning is given to it: all channels interleaved, row-major from the top.
struct DecodedImage {
  int width = 0, height = 0;          ///< of the display window
  std::vector<std::string> channels;  ///< names in the order of the samples
  bool integer_samples = false;       ///< unsigned integers scaled to [0, 1]; else floating point as stored
  std::vector<float> samples;         ///< width × height × channels
  std::map<std::string, std::string> header;
  std::optional<float> exponent;                 ///< of integer samples: sample^exponent is linear; empty: they are sRGB
  std::optional<Chromaticities> chromaticities;  ///< of the file's red, green and blue; empty: it does not say
  std::string colour_profile;                    ///< ICC profile, its bytes; empty: none, or none that is whole
  std::vector<std::string> colour_remarks;       ///< what is not followed of the colour space that the file states
  std::vector<std::string> remarks;              ///< what of the file is not read
};

/// One EXR channel to write: every `stride`-th float from `first`.
struct EncodedChannel {
  std::string name;
  const float* first = nullptr;
  std::size_t stride = 1;
};

/// Each returns an empty text, or one that says what went wrong.
struct ImagePluginFunctions {
  /// `bytes`: a whole file; `format`: OpenImageIO's name of its format.
  std::string (*decode)(std::string_view bytes, const std::string& format, DecodedImage& image);
  std::string (*encode_exr)(int width, int height, std::span<const EncodedChannel> channels,
                            std::span<const std::pair<std::string, std::string>> header, std::vector<char>& bytes);
  /// `rgb`: 8-bit sRGB, three bytes per pixel.
  std::string (*encode_png)(int width, int height, std::span<const std::uint8_t> rgb, std::vector<char>& bytes);
};

inline constexpr const char* image_plugin_file = "gibench_image_plugin.so";
inline constexpr const char* image_plugin_symbol = "gibench_image_plugin";
/// Type of that symbol.
using ImagePluginEntry = const ImagePluginFunctions* (*)();

/// Loads the plugin at the first call. InputError if it is not beside the program or cannot be loaded.
const ImagePluginFunctions& image_plugin();

}  // namespace gibench
