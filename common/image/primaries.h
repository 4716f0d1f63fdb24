/// Colours of other primaries than those of Rec. 709.
#pragma once

#include <array>
#include <optional>

#include "common/core/rgb.h"

namespace gibench {

/// CIE x and y of red, green, blue and white.
using Chromaticities = std::array<float, 8>;

inline constexpr Chromaticities rec709_chromaticities{0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F};

/// Linear RGB of other primaries to that of Rec. 709 (SMPTE RP 177), white to white (Bradford, as in ICC.1:2010, Annex E).
class ColourConversion {
 public:
  /// Empty where the chromaticities span no colours.
  static std::optional<ColourConversion> to_rec709(const Chromaticities& from);

  Rgb operator()(const Rgb& colour) const {
    const RgbDouble c(colour);
    return Rgb(c.r * of_red_ + c.g * of_green_ + c.b * of_blue_);
  }

 private:
  ColourConversion(const RgbDouble& of_red, const RgbDouble& of_green, const RgbDouble& of_blue)
      : of_red_(of_red), of_green_(of_green), of_blue_(of_blue) {}

  RgbDouble of_red_, of_green_, of_blue_;
};

/// Whether they are those of Rec. 709 to the digits in which files state them.
bool are_rec709(const Chromaticities& chromaticities);

}  // namespace gibench
