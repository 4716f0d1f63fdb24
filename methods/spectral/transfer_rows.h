/// The transfer function of vertices projected onto the basis (Wang et al. 2007, Eq. 7 and 8), all functions in one pass.
#pragma once

#include <Eigen/Core>
#include <span>

#include "common/reflectance/spherical_harmonics.h"
#include "methods/spectral/basis.h"
#include "methods/spectral/vertex_rays.h"

namespace gibench::spectral {

/// One block of rows after another, by one thread. The basis is linear, so that the rays' weights are first summed at the
/// slots they meet, Σ over hits of weights; those of all rows are then multiplied with the basis at once, a part at a time.
class TransferRows {
 public:
  TransferRows(const SpectralBasis& basis, const VertexRays& rays) : basis_(basis), rays_(rays) {}

  /// T^s(v, ℓ) for every column, a row for every vertex: E = Σ_ℓ T^s L^s, W/m².
  void irradiance(std::span<const std::uint32_t> vertices, RayStream& rays, std::span<float> rows);
  void irradiance(std::uint32_t vertex, RayStream& rays, std::span<float> row) { irradiance({&vertex, 1}, rays, row); }
  /// The same of one vertex and T_k^s(v, ℓ) for every harmonic k > 0, a row each behind the first; the slice of the constant
  /// harmonic is that number times the irradiance's.
  void with_harmonics(std::uint32_t vertex, RayStream& rays, std::span<float> rows);

  /// The weights at the slots, in place of their projection: nodal gathering through the same rays.
  void nodal(std::uint32_t vertex, RayStream& rays, std::span<float> at_slots);

 private:
  using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void clear(std::size_t rows);
  bool reaches(const SpectralBasis::Part& part) const;
  void project(std::span<float> rows) const;

  const SpectralBasis& basis_;
  const VertexRays& rays_;
  Matrix at_slots_;  // a row for each to be made
};

}  // namespace gibench::spectral
