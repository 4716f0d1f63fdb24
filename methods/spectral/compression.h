/// How coarsely the transfer matrix may be rounded: chosen from what rounding does to light that is tried out.
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/interpolation.h"

namespace gibench::spectral {

/// Irradiance fields of point lights in the open space of the scene, projected onto the basis: three fields to one vector, in
/// its channels, each with an area mean of 1 (0 for a light that nothing sees).
std::vector<std::vector<Rgb4>> trial_lights(const World& world, const SamplingMesh& mesh, const SpectralBasis& basis,
                                            std::span<const std::uint32_t> vertex_of_slot, Task& task);

/// A row of the matrix as it would be without rounding, and the area that it stands for, m².
struct PilotRow {
  std::vector<float> values;
  double area = 0.0;
};

/// Steps, one a column, at which rounding changes the rows' answers to the trial lights by `error` of them (root of the mean
/// square over area and lights). Steps are finer for functions that carry more light: in inverse proportion to the root mean
/// square coefficient of functions of that order in their parts, so that every function may add the same.
std::vector<float> choose_steps(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights,
                                std::span<const PilotRow> rows, double error);

}  // namespace gibench::spectral
