/// Direct light on the mesh: what the nodes hold of it.
#pragma once

#include <vector>

#include "common/lighting/direct_light.h"
#include "methods/spectral/settings.h"
#include "methods/spectral/transfer.h"

namespace gibench::spectral {

/// Irradiance straight from the lights, W/m², one per slot: the mean over the triangles around the node, weighted with the
/// node's hat function, ∫ E φ_v / ∫ φ_v, at `direct_points` stratified points per triangle. No light is lost between nodes:
/// Σ area · E is the light that falls on the scene. Triangles much smaller than what clusters cover have their share of points.
std::vector<Rgb4> direct_irradiance(const World& world, const Transfer& transfer, const DirectLight& light,
                                    const Settings& settings, Task& task);

}  // namespace gibench::spectral
