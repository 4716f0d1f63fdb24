#include "methods/spectral/basis.h"

#include <fmt/format.h>

#include <numeric>
#include <optional>

#include "methods/spectral/eigenvectors.h"

namespace gibench::spectral {

namespace {

constexpr std::uint32_t lane_count = 8;
using Lanes = float __attribute__((vector_size(32), aligned(4), may_alias));
constexpr std::uint32_t most_columns = 65536;  // columns are numbered in 16 bits

Lanes load(const float* from) { return *reinterpret_cast<const Lanes*>(from); }
Lanes all(float value) { return Lanes{value, value, value, value, value, value, value, value}; }

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
    const std::uint32_t width = (functions[p] + lane_count - 1) / lane_count * lane_count;
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
    const auto vertices = std::span(partition.order).subspan(part.begin, part.end - part.begin);
    const SymmetricLaplacian laplacian = symmetric_laplacian(graph, vertices, kind, mean_area);
    auto& pairs = outcome[range.begin];
    pairs = smallest_eigenpairs(laplacian.matrix, part.functions);
    if (!pairs) return;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
      const auto i = static_cast<Eigen::Index>(slot - part.begin);
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
    const float* const first = values_.data() + part.values;
    for (std::uint32_t block = 0; block < part.width; block += lane_count) {
      // Even and odd slots apart: additions that need not wait for one another.
      Lanes red[2] = {all(0), all(0)}, green[2] = {all(0), all(0)}, blue[2] = {all(0), all(0)};
      for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
        const Lanes s = load(first + std::size_t{slot - part.begin} * part.width + block);
        const Rgb4& value = values[slot];
        const std::uint32_t half = slot & 1U;
        const float weight = weight_[slot];
        red[half] += s * all(weight * value.r);
        green[half] += s * all(weight * value.g);
        blue[half] += s * all(weight * value.b);
      }
      const Lanes r = red[0] + red[1], g = green[0] + green[1], b = blue[0] + blue[1];
      for (std::uint32_t i = 0; i < lane_count; ++i) coefficients[part.column + block + i] = Rgb(r[i], g[i], b[i]);
    }
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
