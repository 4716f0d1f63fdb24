#include "methods/spectral/transfer_rows.h"

#include <algorithm>

namespace gibench::spectral {

void TransferRows::nodal(std::uint32_t vertex, RayStream& rays, std::span<float> at_slots) {
  std::fill(at_slots.begin(), at_slots.end(), 0.0F);
  rays_.trace(vertex, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits)
      for (std::size_t c = 0; c < 3; ++c) at_slots[hit.slots[c]] += hit.weights[c];
  });
}

void TransferRows::clear(std::size_t rows) {
  at_slots_.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(basis_.slots()));
}

/// Whether a ray met the part. Weights are not negative but for those of harmonics, whose first row is the plain one.
bool TransferRows::reaches(const SpectralBasis::Part& part) const {
  for (Eigen::Index row = 0; row < at_slots_.rows(); ++row)
    if (at_slots_.row(row).segment(part.begin, part.end - part.begin).maxCoeff() > 0.0F) return true;
  return false;
}

void TransferRows::project(std::span<float> rows) const {
  const Eigen::Index count = at_slots_.rows(), columns = basis_.columns();
  Eigen::Map<Matrix> sums(rows.data(), count, columns);
  for (const SpectralBasis::Part& part : basis_.parts()) {
    const Eigen::Index slots = part.end - part.begin;
    const auto weights = at_slots_.middleCols(part.begin, slots);
    auto sum = sums.middleCols(part.column, part.width);
    if (!reaches(part)) {
      sum.setZero();
      continue;
    }
    const Eigen::Map<const Matrix> functions(basis_.row(part, part.begin).data(), slots, part.width);
    sum.noalias() = weights * functions;
  }
}

void TransferRows::irradiance(std::span<const std::uint32_t> vertices, RayStream& rays, std::span<float> rows) {
  clear(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    nodal(vertices[i], rays, {at_slots_.row(static_cast<Eigen::Index>(i)).data(), basis_.slots()});
  project(rows);
}

void TransferRows::with_harmonics(std::uint32_t vertex, RayStream& rays, std::span<float> rows) {
  clear(harmonic_count);
  at_slots_.setZero();
  rays_.trace(vertex, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits) {
      Harmonics h = spherical_harmonics(hit.direction);
      h[0] = 1.0F;
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < harmonic_count; ++k)
          at_slots_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(hit.slots[c])) += hit.weights[c] * h[k];
    }
  });
  project(rows);
}

}  // namespace gibench::spectral
