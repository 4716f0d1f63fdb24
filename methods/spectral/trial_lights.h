/// Lights by which compression is judged.
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/interpolation.h"

namespace gibench::spectral {

/// Irradiance fields of 48 point lights in the open space of the scene and of three skies, projected onto the basis: three
/// fields to one vector, in its channels, each with an area mean of 1 (0 for a light that nothing sees). Without `occlusion`
/// nothing stands before a point light, and no visibility ray is traced.
std::vector<std::vector<Rgb4>> trial_lights(const World& world, const SamplingMesh& mesh, const SpectralBasis& basis,
                                            std::span<const std::uint32_t> vertex_of_slot, bool occlusion, Task& task);

/// The same with light of one radiance everywhere besides, `ambient` times their means: what bounces add to them.
std::vector<std::vector<Rgb4>> with_ambient(std::vector<std::vector<Rgb4>> lights, const SpectralBasis& basis, float ambient);

}  // namespace gibench::spectral
