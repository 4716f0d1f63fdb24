#include "methods/meshless/fit.h"

#include <algorithm>
#include <vector>

namespace gibench::meshless {

namespace {

constexpr std::size_t fit_chunk = 64;  // points

/// What the function given by the levels up to `last_level` misses of the values; the values themselves for none.
std::vector<Rgb> misses(const Coefficients& coefficients, std::span<const std::uint32_t> points, std::span<const Rgb> values,
                        std::uint32_t level_count, Task& task) {
  std::vector<Rgb> missed(values.begin(), values.end());
  if (level_count == 0) return missed;
  task.parallel_chunks(points.size(), fit_chunk, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      missed[i] -= coefficients.evaluate(coefficients.hierarchy().place(points[i]), level_count - 1);
  });
  return missed;
}

}  // namespace

void fit_level(Coefficients& coefficients, std::uint32_t level, std::span<const std::uint32_t> points,
               std::span<const Rgb> values, int corrections, Task& task) {
  const std::vector<Rgb> differences = misses(coefficients, points, values, level, task);
  for (std::size_t i = 0; i < points.size(); ++i) coefficients.set(points[i], differences[i]);
  for (int correction = 0; correction < corrections; ++correction) {
    const std::vector<Rgb> missed = misses(coefficients, points, values, level + 1, task);
    for (std::size_t i = 0; i < points.size(); ++i) coefficients.add(points[i], missed[i]);
  }
}

Coefficients fit(const Coefficients& values, int corrections, Task& task) {
  const Hierarchy& hierarchy = values.hierarchy();
  Coefficients fitted(hierarchy, values.channels());
  const std::vector<std::uint32_t> points = values.sorted_points();
  auto begin = points.begin();
  for (std::uint32_t level = 0; level < hierarchy.levels() && begin != points.end(); ++level) {
    const auto end = std::lower_bound(begin, points.end(), hierarchy.level_begin(level + 1));
    std::vector<Rgb> of_level;
    for (auto point = begin; point != end; ++point) of_level.push_back(values[*point]);
    fit_level(fitted, level, {begin, end}, of_level, corrections, task);
    begin = end;
  }
  return fitted;
}

}  // namespace gibench::meshless
