#include "methods/spectral/transfer_rows.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gibench::spectral {

namespace {

/// The sums of some functions over slots, eight rows side by side.
template <std::size_t functions>
std::array<Lanes, functions> sums_over(std::span<const std::uint32_t> slots, const SpectralBasis& basis,
                                       const SpectralBasis::Part& part, std::size_t first, const float* at_slots,
                                       std::size_t stride) {
  std::array<Lanes, functions> sums{};
  for (const std::uint32_t slot : slots) {
    const Lanes weights = load_numbers(at_slots + slot * stride);
    const float* const values = basis.row(part, slot).data() + first;
    for (std::size_t f = 0; f < functions; ++f) sums[f] += weights * all_lanes(values[f]);
  }
  return sums;
}

}  // namespace

TransferRows::TransferRows(const SpectralBasis& basis, const VertexRays& rays)
    : basis_(basis), rays_(rays), touched_(basis.slots() / 64 + 1, 0) {}

void TransferRows::begin(std::size_t rows) {
  rows_ = rows;
  stride_ = chunk_count(rows, lane_count) * lane_count;
  if (at_slots_.size() < basis_.slots() * stride_) at_slots_.resize(basis_.slots() * stride_, 0.0F);
}

void TransferRows::nodal(std::uint32_t vertex, RayStream& rays, std::span<float> at_slots) {
  std::fill(at_slots.begin(), at_slots.end(), 0.0F);
  rays_.trace(vertex, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits)
      for (std::size_t c = 0; c < 3; ++c) at_slots[hit.slots[c]] += hit.weights[c];
  });
}

void TransferRows::irradiance(std::span<const std::uint32_t> vertices, RayStream& rays, std::span<float> rows) {
  begin(vertices.size());
  for (std::size_t row = 0; row < vertices.size(); ++row)
    rays_.trace(vertices[row], rays, [&](std::span<const MeshHit> hits) {
      for (const MeshHit& hit : hits)
        for (std::size_t c = 0; c < 3; ++c) touch(hit.slots[c])[row] += hit.weights[c];
    });
  project(rows);
}

void TransferRows::with_harmonics(std::uint32_t vertex, RayStream& rays, std::span<float> rows) {
  begin(harmonic_count);
  rays_.trace(vertex, rays, [&](std::span<const MeshHit> hits) {
    for (const MeshHit& hit : hits) {
      Harmonics h = spherical_harmonics(hit.direction);
      h[0] = 1.0F;
      for (std::size_t c = 0; c < 3; ++c) {
        float* const at = touch(hit.slots[c]);
        for (std::size_t k = 0; k < harmonic_count; ++k) at[k] += hit.weights[c] * h[k];
      }
    }
  });
  project(rows);
}

/// Part by part in the order of slots, so that no sum depends on which ray came first. Leaves the slots untouched.
void TransferRows::project(std::span<float> rows) {
  std::fill(rows.begin(), rows.end(), 0.0F);
  const SpectralBasis::Part* part = nullptr;
  const auto end_part = [&] {
    if (part) project_part(*part, rows);
    for (const std::uint32_t slot : slots_) std::fill_n(&at_slots_[slot * stride_], stride_, 0.0F);
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

void TransferRows::project_part(const SpectralBasis::Part& part, std::span<float> rows) const {
  const std::size_t columns = basis_.columns();
  const auto write = [&](std::size_t first_row, std::size_t function, const Lanes& sum) {
    for (std::size_t r = first_row; r < std::min(rows_, first_row + lane_count); ++r)
      rows[r * columns + part.column + function] = sum[r - first_row];
  };
  for (std::size_t row = 0; row < rows_; row += lane_count) {
    const float* const at = at_slots_.data() + row;
    if (part.width == 1) {
      write(row, 0, sums_over<1>(slots_, basis_, part, 0, at, stride_).front());
      continue;
    }
    for (std::size_t first = 0; first < part.functions; first += lane_count) {
      const auto sums = sums_over<lane_count>(slots_, basis_, part, first, at, stride_);
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
