#include "methods/spectral/basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "methods/spectral/colour_lanes.h"
#include "methods/spectral/eigenvectors.h"

namespace gibench::spectral {

namespace {

constexpr std::uint32_t most_columns = 65536;  // columns are numbered in 16 bits

constexpr std::uint32_t tile = 128;  // slots whose functions stay in the nearest cache

/// Adds Σ s · value over a tile for `count` times eight functions; `sums` as many.
template <std::size_t count>
void add_tile(const float* functions, std::size_t width, std::span<const Rgb4> values, ColourLanes* sums) {
  std::array<ColourLanes, count> sum;
  std::copy_n(sums, count, sum.begin());
  for (const Rgb4& value : values) {
    for (std::size_t i = 0; i < count; ++i) sum[i].add(load_numbers(functions + i * lane_count), value);
    functions += width;
  }
  std::copy_n(sum.begin(), count, sums);
}

/// Σ wᵢ s_ℓ(i) value(i) over the slots of a part, for every column of it.
template <class ValueAt>
void project_part(const SpectralBasis& basis, const SpectralBasis::Part& part, const ValueAt& value_at, std::span<Rgb4> columns) {
  std::vector<ColourLanes> sums(part.width / lane_count);
  std::array<Rgb4, tile> weighted;
  for (std::uint32_t begin = part.begin; begin < part.end; begin += tile) {
    const std::uint32_t count = std::min(tile, part.end - begin);
    for (std::uint32_t i = 0; i < count; ++i) weighted[i] = value_at(begin + i) * basis.weight()[begin + i];
    const std::span<const Rgb4> values = std::span(weighted).first(count);
    const float* functions = basis.row(part, begin).data();
    std::size_t done = 0;  // as many functions at a time as there are registers for
    for (; done + 4 <= sums.size(); done += 4) add_tile<4>(functions + done * lane_count, part.width, values, &sums[done]);
    for (; done < sums.size(); ++done) add_tile<1>(functions + done * lane_count, part.width, values, &sums[done]);
  }
  for (std::size_t i = 0; i < sums.size(); ++i) store(sums[i], &columns[i * lane_count]);
}

std::string describe(const Partition& partition, std::size_t part) {
  return fmt::format("part {} of {} ({} vertices)", part + 1, partition.parts(), partition.part_size(part));
}

}  // namespace

BasisMaking BasisMaking::make(const SurfaceGraph& graph, const Partition& partition, const std::vector<std::uint32_t>& functions,
                              Laplacian kind, Task& task) {
  BasisMaking making;
  SpectralBasis& basis = making.basis;
  std::size_t values = 0;
  std::uint64_t columns = 0;
  for (std::size_t p = 0; p < partition.parts(); ++p) {
    const std::uint32_t width = static_cast<std::uint32_t>(chunk_count(functions[p], lane_count) * lane_count);
    basis.parts_.push_back(
        {partition.part_begin[p], partition.part_begin[p + 1], static_cast<std::uint32_t>(columns), width, functions[p], values});
    columns += width;
    values += std::size_t{width} * partition.part_size(p);
  }
  if (columns > most_columns) {
    making.failure = fmt::format(
        "{} parts need {} columns where there may be {}; lower basis_functions, or join the scene's loose "
        "pieces, of which each is a part",
        partition.parts(), columns, most_columns);
    return making;
  }
  basis.values_.assign(values, 0.0F);
  basis.weight_.assign(graph.size(), 1.0F);
  basis.part_of_slot_.resize(graph.size());
  const double mean_area = std::accumulate(graph.area.begin(), graph.area.end(), 0.0) / static_cast<double>(graph.size());
  std::vector<std::optional<Eigenpairs>> outcome(partition.parts());
  task.parallel_chunks(partition.parts(), 1, [&](const ChunkRange& range) {
    const SpectralBasis::Part& part = basis.parts_[range.begin];
    std::vector<std::uint32_t> ascending(partition.order.begin() + part.begin, partition.order.begin() + part.end);
    std::sort(ascending.begin(), ascending.end());
    const SymmetricLaplacian laplacian = symmetric_laplacian(graph, ascending, kind, mean_area);
    auto& pairs = outcome[range.begin];
    pairs = smallest_eigenpairs(laplacian.matrix, part.functions);
    if (!pairs) return;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
      const Eigen::Index i = std::lower_bound(ascending.begin(), ascending.end(), partition.order[slot]) - ascending.begin();
      basis.weight_[slot] = static_cast<float>(laplacian.weight[i]);
      basis.part_of_slot_[slot] = static_cast<std::uint16_t>(range.begin);
      float* row = basis.values_.data() + part.values + std::size_t{slot - part.begin} * part.width;
      for (std::uint32_t f = 0; f < part.functions; ++f)
        row[f] = static_cast<float>(pairs->vectors(i, static_cast<Eigen::Index>(f)) / std::sqrt(laplacian.weight[i]));
    }
    pairs->vectors.resize(0, 0);
  });
  if (task.cancelled()) return making;
  for (std::size_t p = 0; p < partition.parts(); ++p) {
    if (!outcome[p]) {
      making.failure = fmt::format(
          "the eigenvectors of {} were not found: three shifts of the Lanczos solver failed, and {}; set "
          "another part_vertices",
          describe(partition, p),
          partition.part_size(p) > most_dense ? "it is too large for the dense one" : "so did the dense one");
      return making;
    }
    making.dense_parts += outcome[p]->dense ? 1U : 0U;
    making.failed_attempts += static_cast<std::uint32_t>(outcome[p]->failed_attempts);
  }
  return making;
}

std::uint32_t SpectralBasis::functions() const {
  return std::accumulate(parts_.begin(), parts_.end(), 0U,
                         [](std::uint32_t sum, const Part& part) { return sum + part.functions; });
}

std::vector<float> SpectralBasis::constant() const {
  std::vector<float> projected(columns(), 0.0F);
  for (const Part& part : parts_) {
    double sum = 0.0;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot)
      sum += static_cast<double>(weight_[slot]) * static_cast<double>(row(part, slot).front());
    projected[part.column] = static_cast<float>(sum);
  }
  return projected;
}

void SpectralBasis::project(std::span<const Rgb4> values, std::span<Rgb4> coefficients, Task& task) const {
  task.parallel_chunks(parts_.size(), 1, [&](const ChunkRange& range) {
    const Part& part = parts_[range.begin];
    project_part(
        *this, part, [&](std::uint32_t slot) { return Rgb(values[slot]); }, coefficients.subspan(part.column, part.width));
  });
}

void SpectralBasis::project_reflected(std::span<const Rgb4> reflectance, std::span<const Rgb4> direct,
                                      std::span<const Rgb4> indirect, std::span<Rgb4> coefficients, Task& task) const {
  task.parallel_chunks(parts_.size(), 1, [&](const ChunkRange& range) {
    const Part& part = parts_[range.begin];
    project_part(
        *this, part, [&](std::uint32_t slot) { return Rgb(reflectance[slot]) * (Rgb(direct[slot]) + Rgb(indirect[slot])); },
        coefficients.subspan(part.column, part.width));
  });
}

void SpectralBasis::reconstruct(std::span<const Rgb4> coefficients, std::span<Rgb4> values, Task& task) const {
  task.parallel_chunks(parts_.size(), 1, [&](const ChunkRange& range) {
    const Part& part = parts_[range.begin];
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
      Rgb sum;
      const std::span<const float> functions = row(part, slot);
      for (std::uint32_t f = 0; f < part.functions; ++f) sum += Rgb(coefficients[part.column + f]) * functions[f];
      values[slot] = sum;
    }
  });
}

}  // namespace gibench::spectral
