#include "methods/meshless/refinement.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gibench::meshless {

namespace {

constexpr std::size_t search_chunk = 64;  // points

float largest_magnitude(const Rgb& value) { return std::max({std::fabs(value.r), std::fabs(value.g), std::fabs(value.b)}); }

/// One approximation in the making.
class Refinement {
 public:
  Refinement(const Hierarchy& hierarchy, const PointValues& values, double epsilon_e, Task& task)
      : hierarchy_(hierarchy),
        values_(values),
        epsilon_e_(epsilon_e),
        task_(task),
        coefficients_(hierarchy),
        asked_(hierarchy.size(), 0) {}

  void set_threshold(const Rgb& solution_mean) {
    const RgbDouble mean = coarsest_mean(coefficients_) + RgbDouble(solution_mean);
    threshold_ = static_cast<float>(epsilon_e_ * (mean.r + mean.g + mean.b) / 3.0);
  }

  std::vector<std::uint32_t> coarsest() {
    std::vector<std::uint32_t> points(hierarchy_.level_size(0));
    std::iota(points.begin(), points.end(), 0U);
    return mark(points);
  }

  /// Computes the coefficients of points whose parents are computed or among them; sorted coarse to fine.
  void compute(const std::vector<std::uint32_t>& points) {
    std::vector<Rgb> values(points.size());
    values_(points, values);
    auto begin = points.begin();
    for (std::uint32_t level = 0; level < hierarchy_.levels() && begin != points.end(); ++level) {
      const auto end = std::lower_bound(begin, points.end(), hierarchy_.level_begin(level + 1));
      const auto first = static_cast<std::size_t>(begin - points.begin());
      const auto count = static_cast<std::size_t>(end - begin);
      if (level > 0) subtract_parents(std::span(points).subspan(first, count), std::span(values).subspan(first, count), level);
      for (std::size_t i = first; i < first + count; ++i) coefficients_.set(points[i], values[i]);
      begin = end;
    }
  }

  /// The functions to compute next, parents included, on behalf of the newly computed points.
  std::vector<std::uint32_t> refine(const std::vector<std::uint32_t>& computed) {
    std::vector<std::uint32_t> wanted = mark(search(computed, [this](std::uint32_t point, std::vector<std::uint32_t>& found) {
      if (needs_refinement(point)) find_children(point, found);
    }));
    std::vector<std::uint32_t> parents = wanted;
    while (!parents.empty()) {
      parents =
          mark(search(parents, [this](std::uint32_t point, std::vector<std::uint32_t>& found) { find_parents(point, found); }));
      wanted.insert(wanted.end(), parents.begin(), parents.end());
    }
    std::sort(wanted.begin(), wanted.end());
    return wanted;
  }

  Coefficients take() { return std::move(coefficients_); }

 private:
  using Search = std::function<void(std::uint32_t point, std::vector<std::uint32_t>& found)>;

  /// Runs a search for every point on all threads; what was found, in the order of the points.
  std::vector<std::uint32_t> search(const std::vector<std::uint32_t>& points, const Search& visit) {
    std::vector<std::vector<std::uint32_t>> found(chunk_count(points.size(), search_chunk));
    task_.parallel_chunks(points.size(), search_chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) visit(points[i], found[range.chunk]);
    });
    std::vector<std::uint32_t> all;
    for (const std::vector<std::uint32_t>& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
  }

  /// Those that nobody has asked for yet, each once.
  std::vector<std::uint32_t> mark(const std::vector<std::uint32_t>& points) {
    std::vector<std::uint32_t> fresh;
    for (std::uint32_t point : points)
      if (asked_[point] == 0) {
        asked_[point] = 1;
        fresh.push_back(point);
      }
    return fresh;
  }

  bool needs_refinement(std::uint32_t point) const {
    if (point >= hierarchy_.level_begin(1)) return largest_magnitude(coefficients_[point]) > threshold_;
    bool varies = false;
    hierarchy_.visit_covering(0, hierarchy_.place(point), [&](std::uint32_t other, float) {
      varies = varies || largest_magnitude(coefficients_[point] - coefficients_[other]) > threshold_;
    });
    return varies;
  }

  void find_children(std::uint32_t point, std::vector<std::uint32_t>& found) const {
    const std::uint32_t level = hierarchy_.level_of(point) + 1;
    if (level >= hierarchy_.levels()) return;
    hierarchy_.visit_covering(level, hierarchy_.place(point), [&](std::uint32_t child, float) {
      if (asked_[child] == 0) found.push_back(child);
    });
  }

  /// Every coarser function that covers the point and was not asked for; those of level 0 all were.
  void find_parents(std::uint32_t point, std::vector<std::uint32_t>& found) const {
    const Place at = hierarchy_.place(point);
    const std::uint32_t own_level = hierarchy_.level_of(point);
    for (std::uint32_t level = 1; level < own_level; ++level)
      hierarchy_.visit_covering(level, at, [&](std::uint32_t parent, float) {
        if (asked_[parent] == 0) found.push_back(parent);
      });
  }

  /// Eq. 10: values become differences to the approximation of the coarser levels.
  void subtract_parents(std::span<const std::uint32_t> points, std::span<Rgb> values, std::uint32_t level) {
    task_.parallel_chunks(points.size(), search_chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i)
        values[i] -= coefficients_.evaluate(hierarchy_.place(points[i]), level - 1);
    });
  }

  const Hierarchy& hierarchy_;
  const PointValues& values_;
  double epsilon_e_;
  Task& task_;
  Coefficients coefficients_;
  std::vector<std::uint8_t> asked_;  ///< computed or about to be
  float threshold_ = 0.0F;           ///< W/m²
};

}  // namespace

RgbDouble coarsest_mean(const Coefficients& coefficients) {
  const std::uint32_t count = coefficients.hierarchy().level_size(0);
  RgbDouble sum;
  for (std::uint32_t point = 0; point < count; ++point) sum += RgbDouble(coefficients[point]);
  return count > 0 ? sum / static_cast<double>(count) : sum;
}

Coefficients approximate(const Hierarchy& hierarchy, const PointValues& values, const RefinementRule& rule, Task& task) {
  Refinement refinement(hierarchy, values, rule.epsilon_e, task);
  std::vector<std::uint32_t> wanted = refinement.coarsest();
  refinement.compute(wanted);
  refinement.set_threshold(rule.solution_mean);
  while (!task.cancelled()) {
    wanted = refinement.refine(wanted);
    if (wanted.empty()) break;
    refinement.compute(wanted);
  }
  return refinement.take();
}

}  // namespace gibench::meshless
