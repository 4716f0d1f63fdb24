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

void TransferRows::irradiance(std::uint32_t vertex, RayStream& rays, std::span<float> row) {
  nodal(vertex, rays, at_slots_);
  std::fill(row.begin(), row.end(), 0.0F);
  for (const SpectralBasis::Part& part : basis_.parts()) {
    float* const sum = row.data() + part.column;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
      const float weight = at_slots_[slot];
      if (weight == 0.0F) continue;
      const float* const functions = basis_.row(part, slot).data();
      for (std::uint32_t f = 0; f < part.width; ++f) sum[f] += weight * functions[f];
    }
  }
}

void TransferRows::with_harmonics(std::uint32_t vertex, RayStream& rays, std::span<float> rows) {
  std::fill(at_slots_.begin(), at_slots_.end(), 0.0F);
  harmonics_at_slots_.assign(at_slots_.size(), Harmonics{});
  rays_.trace(vertex, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits) {
      const Harmonics h = spherical_harmonics(hit.direction);
      for (std::size_t c = 0; c < 3; ++c) {
        at_slots_[hit.slots[c]] += hit.weights[c];
        Harmonics& sum = harmonics_at_slots_[hit.slots[c]];
        for (std::size_t k = 1; k < harmonic_count; ++k) sum[k] += hit.weights[c] * h[k];
      }
    }
  });
  std::fill(rows.begin(), rows.end(), 0.0F);
  const std::size_t columns = basis_.columns();
  for (const SpectralBasis::Part& part : basis_.parts())
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
      if (at_slots_[slot] == 0.0F) continue;
      const float* const functions = basis_.row(part, slot).data();
      for (std::size_t k = 0; k < harmonic_count; ++k) {
        const float weight = k == 0 ? at_slots_[slot] : harmonics_at_slots_[slot][k];
        float* const sum = rows.data() + k * columns + part.column;
        for (std::uint32_t f = 0; f < part.width; ++f) sum[f] += weight * functions[f];
      }
    }
}

}  // namespace gibench::spectral
