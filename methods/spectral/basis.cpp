#include "methods/spectral/basis.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "methods/spectral/colour_lanes.h"

namespace gibench::spectral {

namespace {

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

/// Floats that a slot has of a part with so many functions.
std::uint32_t width_for(std::uint32_t functions) {
  return functions == 1 ? 1 : static_cast<std::uint32_t>(chunk_count(functions, lane_count) * lane_count);
}

/// Σ wᵢ s_ℓ(i) value(i) over the slots of a part, for every column of it.
template <class ValueAt>
void project_part(const SpectralBasis& basis, const SpectralBasis::Part& part, const ValueAt& value_at, std::span<Rgb4> columns) {
  if (part.width == 1) {
    Rgb sum;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot)
      sum += value_at(slot) * (basis.weight()[slot] * basis.row(part, slot).front());
    columns.front() = sum;
    return;
  }
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
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::array<Rgb4, lane_count> stored;
    store(sums[i], stored.data());
    std::copy_n(stored.begin(), std::min(lane_count, columns.size() - i * lane_count), &columns[i * lane_count]);
  }
}

}  // namespace

SpectralBasis::SpectralBasis(const Partition& partition, std::span<const std::uint32_t> functions)
    : part_of_slot_(partition.order.size()), weight_(partition.order.size(), 1.0F) {
  std::size_t values = 0;
  std::uint32_t columns = 0;
  for (std::size_t p = 0; p < partition.parts(); ++p) {
    const std::uint32_t begin = partition.part_begin[p], end = partition.part_begin[p + 1], width = width_for(functions[p]);
    parts_.push_back({begin, end, columns, functions[p], width, values});
    std::fill(part_of_slot_.begin() + begin, part_of_slot_.begin() + end, static_cast<std::uint16_t>(p));
    columns += functions[p];
    values += std::size_t{width} * partition.part_size(p);
  }
  values_.assign(values, 0.0F);
}

std::uint64_t SpectralBasis::columns_for(std::span<const std::uint32_t> functions) {
  return std::accumulate(functions.begin(), functions.end(), std::uint64_t{0});
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
        *this, part, [&](std::uint32_t slot) { return Rgb(values[slot]); }, coefficients.subspan(part.column, part.functions));
  });
}

void SpectralBasis::project_reflected(std::span<const Rgb4> reflectance, std::span<const Rgb4> direct,
                                      std::span<const Rgb4> indirect, std::span<Rgb4> coefficients, Task& task) const {
  task.parallel_chunks(parts_.size(), 1, [&](const ChunkRange& range) {
    const Part& part = parts_[range.begin];
    project_part(
        *this, part, [&](std::uint32_t slot) { return Rgb(reflectance[slot]) * (Rgb(direct[slot]) + Rgb(indirect[slot])); },
        coefficients.subspan(part.column, part.functions));
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
