/// How coarsely the transfer matrix may be rounded: chosen from what rounding does to light that is tried out.
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/interpolation.h"

namespace gibench::spectral {

/// Irradiance fields of twelve point lights in the open space of the scene and of three skies, projected onto the basis: three
/// fields to one vector, in its channels, each with an area mean of 1 (0 for a light that nothing sees). Without `occlusion`
/// nothing stands before a point light, and no visibility ray is traced.
std::vector<std::vector<Rgb4>> trial_lights(const World& world, const SamplingMesh& mesh, const SpectralBasis& basis,
                                            std::span<const std::uint32_t> vertex_of_slot, bool occlusion, Task& task);

/// The same with light of one radiance everywhere besides, `ambient` times their means: what bounces add to them.
std::vector<std::vector<Rgb4>> with_ambient(std::vector<std::vector<Rgb4>> lights, const SpectralBasis& basis, float ambient);

/// A row of the matrix as it would be without rounding, and the area that it stands for, m².
struct PilotRow {
  std::vector<float> values;
  std::vector<float> others[2];  ///< the same by other rays, independent; empty: the values are exact
  double area = 0.0;
};

/// Steps, one a column, at which rounding adds `error` to the error of the rows' answers to a trial light, as a share of them
/// (root of the mean square over area), to the worst of them. The squared error of x is (x − A)(x − B), A and B by independent
/// rays: against the truth, so that dropping what is but the rays' noise adds nothing. Steps are finer for functions that carry
/// more light: in inverse proportion to the root mean square coefficient of functions of that order in their parts, so that every
/// function may add the same.
std::vector<float> choose_steps(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights,
                                std::span<const PilotRow> rows, double error);

}  // namespace gibench::spectral
