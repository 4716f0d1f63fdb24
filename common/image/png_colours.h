/// The colour space that a PNG states in its chunks.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/image/primaries.h"

namespace gibench {

/// Of sRGB where it is empty.
struct PngColours {
  std::optional<float> exponent;                 ///< sample^exponent is linear (gAMA)
  std::optional<Chromaticities> chromaticities;  ///< of red, green, blue and white (cHRM)
  std::string profile_name;                      ///< keyword of an ICC profile (iCCP); empty: none
  std::vector<std::string> remarks;              ///< what is not followed
};

/// What counts of the chunks before the pixels of a whole PNG (PNG specification, third edition, 11.3.2): sRGB before gAMA and
/// cHRM, which say the same to programs that do not know it. An empty answer for bytes that do not begin as a PNG.
PngColours colours_of_png(std::string_view bytes);

}  // namespace gibench
