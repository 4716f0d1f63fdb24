/// The exposure at which a picture is shown where its scene stores none.
#pragma once

#include <span>

#include "common/core/rgb.h"
#include "common/image/exposure.h"

namespace gibench {

/// An exposure for a scene that stores none, from the luminance of the reference image: the geometric mean of the pixels
/// that are not black is shown as 0.18 (Reinhard et al. 2002), the range is that of HDR-FLIP (automatic_exposures).
Exposure automatic_exposure(std::span<const Rgb> pixels);

}  // namespace gibench
