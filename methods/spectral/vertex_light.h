/// Direct light on the mesh: what the vertices hold of it.
#pragma once

#include <vector>

#include "common/lighting/direct_light.h"
#include "methods/spectral/settings.h"
#include "methods/spectral/transfer.h"

namespace gibench::spectral {

/// Irradiance straight from the lights, W/m², one per slot: the mean over the triangles around the vertex, weighted with the
/// vertex's hat function, ∫ E φ_v / ∫ φ_v, at `direct_points` stratified points per triangle. No light is lost between vertices:
/// Σ area · E is the light that falls on the scene.
std::vector<Rgb4> direct_irradiance(const World& world, const Transfer& transfer, const DirectLight& light,
                                    const Settings& settings, Task& task);

}  // namespace gibench::spectral
