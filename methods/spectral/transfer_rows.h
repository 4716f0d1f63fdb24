/// The transfer function of vertices projected onto the basis (Wang et al. 2007, Eq. 7 and 8), all functions in one pass.
#pragma once

#include <span>
#include <vector>

#include "common/reflectance/spherical_harmonics.h"
#include "methods/spectral/basis.h"
#include "methods/spectral/vertex_rays.h"

namespace gibench::spectral {

/// One row after another, by one thread. The basis is linear, so that the rays' weights are first summed at the slots they
/// meet, Σ over hits of weights, and then each slot is multiplied with its few functions.
class TransferRows {
 public:
  TransferRows(const SpectralBasis& basis, const VertexRays& rays) : basis_(basis), rays_(rays), at_slots_(basis.slots(), 0.0F) {}

  /// T^s(v, ℓ) for every column: E = Σ_ℓ T^s L^s, W/m².
  void irradiance(std::uint32_t vertex, RayStream& rays, std::span<float> row);
  /// The same and T_k^s(v, ℓ) for every harmonic k > 0, a row each behind the first; the slice of the constant harmonic is
  /// that number times the irradiance's.
  void with_harmonics(std::uint32_t vertex, RayStream& rays, std::span<float> rows);

  /// The weights at the slots, in place of their projection: nodal gathering through the same rays.
  void nodal(std::uint32_t vertex, RayStream& rays, std::span<float> at_slots);

 private:
  const SpectralBasis& basis_;
  const VertexRays& rays_;
  std::vector<float> at_slots_;
  std::vector<Harmonics> harmonics_at_slots_;
};

}  // namespace gibench::spectral
