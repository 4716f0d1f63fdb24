#include "methods/spectral/transfer_rows.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gibench::spectral {

namespace {

/// The sums of some functions over slots, eight rows side by side. `weights`: of the first slot, `stride` from one to the next.
template <std::size_t functions>
std::array<Lanes, functions> sums_over(std::span<const std::uint32_t> slots, const SpectralBasis& basis,
                                       const SpectralBasis::Part& part, std::size_t first, const float* weights,
                                       std::size_t stride) {
  std::array<Lanes, functions> sums{};
  const float* const row_of_first = basis.row(part, part.begin).data() + first;
  for (const std::uint32_t slot : slots) {
    const Lanes own = load_numbers(weights);
    weights += stride;
    const float* const values = row_of_first + std::size_t{slot - part.begin} * part.width;
    for (std::size_t f = 0; f < functions; ++f) sums[f] += own * all_lanes(values[f]);
  }
  return sums;
}

}  // namespace

TransferRows::TransferRows(const SpectralBasis& basis, const VertexRays& rays)
    : basis_(basis), rays_(rays), touched_(basis.slots() / 64 + 1, 0) {}

void TransferRows::begin(std::size_t rows) {
  rows_ = rows;
  if (at_slots_.size() < basis_.slots() * rows) at_slots_.resize(basis_.slots() * rows, 0.0F);
}

void TransferRows::nodal(std::uint32_t node, RayStream& rays, std::span<float> at_slots) {
  std::fill(at_slots.begin(), at_slots.end(), 0.0F);
  rays_.trace(node, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits) rays_.each_slot(hit, [&](std::uint32_t slot, float weight) { at_slots[slot] += weight; });
  });
}

void TransferRows::irradiance(std::span<const std::uint32_t> nodes, RayStream& rays, std::span<float> rows) {
  begin(nodes.size());
  for (std::size_t row = 0; row < nodes.size(); ++row)
    rays_.trace(nodes[row], rays, [&, at = at_slots(row)](std::span<const MeshHit> hits) {
      for (const MeshHit& hit : hits)
        rays_.each_slot(hit, [&](std::uint32_t slot, float weight) {
          touch(slot);
          at[slot] += weight;
        });
    });
  project(rows);
}

void TransferRows::with_harmonics(std::uint32_t node, RayStream& rays, std::span<float> rows) {
  begin(harmonic_count);
  rays_.trace(node, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits) {
      Harmonics h = spherical_harmonics(hit.direction);
      h[0] = 1.0F;
      rays_.each_slot(hit, [&](std::uint32_t slot, float weight) {
        touch(slot);
        for (std::size_t k = 0; k < harmonic_count; ++k) at_slots(k)[slot] += weight * h[k];
      });
    }
  });
  project(rows);
}

std::vector<std::vector<float>> TransferRows::with_harmonics(std::span<const std::uint32_t> nodes, RayStream& rays) {
  const std::size_t columns = basis_.columns();
  std::vector<std::vector<float>> rows(harmonic_count);
  std::vector<float> all(harmonic_count * columns);
  for (const std::uint32_t node : nodes) {
    with_harmonics(node, rays, all);
    for (std::size_t k = 0; k < harmonic_count; ++k) {
      const std::span<const float> row = std::span(all).subspan(k * columns, columns);
      rows[k].insert(rows[k].end(), row.begin(), row.end());
    }
  }
  return rows;
}

/// Part by part in the order of slots, so that no sum depends on which ray came first. Leaves the slots untouched.
void TransferRows::project(std::span<float> rows) {
  std::fill(rows.begin(), rows.end(), 0.0F);
  const SpectralBasis::Part* part = nullptr;
  const auto end_part = [&] {
    if (part) project_part(*part, rows);
    slots_.clear();
  };
  for (std::uint32_t word = 0; word < touched_.size(); ++word) {
    for (std::uint64_t bits = touched_[word]; bits != 0; bits &= bits - 1) {
      const std::uint32_t slot = word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      if (!part || slot >= part->end) {
        end_part();
        part = &basis_.part_of(slot);
      }
      slots_.push_back(slot);
    }
    touched_[word] = 0;
  }
  end_part();
}

/// Those of the touched slots, which are zero then.
void TransferRows::take_weights() {
  const std::size_t stride = chunk_count(rows_, lane_count) * lane_count;
  weights_.assign(slots_.size() * stride, 0.0F);
  for (std::size_t row = 0; row < rows_; ++row) {
    float* const at = at_slots(row);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      weights_[i * stride + row] = at[slots_[i]];
      at[slots_[i]] = 0.0F;
    }
  }
}

void TransferRows::project_part(const SpectralBasis::Part& part, std::span<float> rows) {
  take_weights();
  const std::size_t columns = basis_.columns(), stride = chunk_count(rows_, lane_count) * lane_count;
  const auto write = [&](std::size_t first_row, std::size_t function, const Lanes& sum) {
    for (std::size_t r = first_row; r < std::min(rows_, first_row + lane_count); ++r)
      rows[r * columns + part.column + function] = sum[r - first_row];
  };
  for (std::size_t row = 0; row < rows_; row += lane_count) {
    const float* const weights = weights_.data() + row;
    if (part.width == 1) {
      write(row, 0, sums_over<1>(slots_, basis_, part, 0, weights, stride).front());
      continue;
    }
    for (std::size_t first = 0; first < part.functions; first += lane_count) {
      const auto sums = sums_over<lane_count>(slots_, basis_, part, first, weights, stride);
      for (std::size_t f = 0; f < std::min<std::size_t>(lane_count, part.functions - first); ++f) write(row, first + f, sums[f]);
    }
  }
}

std::unique_ptr<TransferRows> TransferRowsPool::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<TransferRows> maker = std::move(idle_.back());
      idle_.pop_back();
      return maker;
    }
  }
  return std::make_unique<TransferRows>(basis_, rays_);
}

}  // namespace gibench::spectral
