/// Direct light projected onto the basis (section 5.1).
#pragma once

#include "common/lighting/direct_light.h"
#include "methods/wavelet/transform.h"

namespace gibench::wavelet {

/// Irradiance straight from the lights, W/m²: the coefficients of its means over the leaves, each from the leaf's points with
/// `samples` light samples at each.
Coefficients<Rgb> project_direct_light(const World& world, const Elements& elements, const DirectLight& light, int samples,
                                       Task& task);

}  // namespace gibench::wavelet
