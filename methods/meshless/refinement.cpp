#include "methods/meshless/refinement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "methods/meshless/fit.h"

namespace gibench::meshless {

namespace {

constexpr std::size_t search_chunk = 64;  // points
constexpr double slowest_fading = 0.95;   // of the terms of a series, for foreseeing its sum
constexpr double negligible_term = 1e-3;  // of that sum

float largest_magnitude(const Rgb& value) { return std::max({std::fabs(value.r), std::fabs(value.g), std::fabs(value.b)}); }

/// One approximation in the making.
class Refinement {
 public:
  Refinement(const Hierarchy& hierarchy, const PointValues& values, const RefinementRule& rule, Task& task)
      : hierarchy_(hierarchy),
        values_(values),
        rule_(rule),
        task_(task),
        point_values_(hierarchy, rule.channels),
        coefficients_(hierarchy, rule.channels),
        asked_(hierarchy.size(), 0),
        deviation_(hierarchy.size(), 0.0F),
        spread_(hierarchy.size(), 0.0F) {}

  void set_threshold() {
    const double own = channel_mean(coarsest_mean(point_values_));
    double reference = rule_.solution_mean + own;
    const double ratio = rule_.previous_mean > 0.0 ? std::clamp(own / rule_.previous_mean, 0.0, slowest_fading) : 0.0;
    double term = own * ratio;
    for (int left = rule_.terms_left; left > 0 && term > reference * negligible_term; --left, term *= ratio) reference += term;
    if (rule_.threshold_mean == ThresholdMean::irradiance && own > 0.0) reference *= weighted_mean() / own;
    threshold_ = static_cast<float>(rule_.epsilon_e * reference);
  }

  /// All points of the levels that are not refined but computed wholly.
  std::vector<std::uint32_t> first_points() {
    std::vector<std::uint32_t> points(hierarchy_.level_begin(std::min(rule_.full_level, hierarchy_.levels() - 1) + 1));
    std::iota(points.begin(), points.end(), 0U);
    return mark(points);
  }

  /// Computes the coefficients of points whose parents are computed or among them; sorted coarse to fine.
  void compute(const std::vector<std::uint32_t>& points) {
    std::vector<Estimate> estimates(points.size());
    values_(points, estimates);
    std::vector<Rgb> values;
    for (std::size_t i = 0; i < points.size(); ++i) {
      values.push_back(estimates[i].value);
      point_values_.set(points[i], estimates[i].value);
      deviation_[points[i]] = estimates[i].deviation;
      spread_[points[i]] = static_cast<float>(rule_.proximity) * hierarchy_.radius(points[i]) * estimates[i].slope;
    }
    auto begin = points.begin();
    for (std::uint32_t level = 0; level < hierarchy_.levels() && begin != points.end(); ++level) {
      const auto end = std::lower_bound(begin, points.end(), hierarchy_.level_begin(level + 1));
      const auto first = static_cast<std::size_t>(begin - points.begin());
      fit_level(coefficients_, level, {begin, end}, std::span(values).subspan(first, static_cast<std::size_t>(end - begin)),
                rule_.corrections, task_);
      begin = end;
    }
  }

  /// The functions to compute next, parents included, on behalf of the newly computed points.
  std::vector<std::uint32_t> refine(const std::vector<std::uint32_t>& computed) {
    std::vector<std::uint32_t> undecided;
    std::vector<std::uint32_t> wanted = mark(search(
        computed,
        [this](std::uint32_t point, std::vector<std::uint32_t>& found, std::vector<std::uint32_t>& open) {
          const Detail detail = detail_at(point);
          if (detail == Detail::found) find_children(point, found);
          if (detail == Detail::undecided && point < hierarchy_.level_begin(hierarchy_.levels() - 1)) open.push_back(point);
        },
        &undecided));
    undecided_ += undecided.size();
    std::vector<std::uint32_t> parents = wanted;
    while (!parents.empty()) {
      parents = mark(search(parents, [this](std::uint32_t point, std::vector<std::uint32_t>& found, std::vector<std::uint32_t>&) {
        find_parents(point, found);
      }));
      wanted.insert(wanted.end(), parents.begin(), parents.end());
    }
    std::sort(wanted.begin(), wanted.end());
    return wanted;
  }

  /// The coefficients, fitted anew once all points are known where the order of their coming left its mark.
  Coefficients finish() {
    task_.count("undecided_samples", undecided_);
    return rule_.corrections > 0 ? fit(point_values_, rule_.corrections, task_) : std::move(coefficients_);
  }

 private:
  using Points = std::vector<std::uint32_t>;
  using Search = std::function<void(std::uint32_t point, Points& found, Points& open)>;

  /// Runs a search for every point on all threads; what was found, in the order of the points, and what was left open.
  Points search(const Points& points, const Search& visit, Points* left_open = nullptr) {
    std::vector<Points> found(chunk_count(points.size(), search_chunk)), open(found.size());
    task_.parallel_chunks(points.size(), search_chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) visit(points[i], found[range.chunk], open[range.chunk]);
    });
    Points all;
    for (const Points& some : found) all.insert(all.end(), some.begin(), some.end());
    if (left_open)
      for (const Points& some : open) left_open->insert(left_open->end(), some.begin(), some.end());
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

  /// What RECEIVER-ORACLE says of a difference.
  enum class Detail { none, undecided, found };

  /// ΣE² / ΣE over the surfaces, of the mean of the channels.
  double weighted_mean() const {
    double sum = 0.0, squares = 0.0;
    for (std::uint32_t point = 0; point < hierarchy_.level_size(0); ++point) {
      const double value = channel_mean(RgbDouble(point_values_[point])), share = hierarchy_.coarsest_share(point);
      sum += share * value;
      squares += share * value * value;
    }
    return sum > 0.0 ? squares / sum : 0.0;
  }

  float threshold_at(std::uint32_t point) const {
    return threshold_ * static_cast<float>(std::pow(rule_.level_growth, hierarchy_.level_of(point)));
  }

  /// Of all that it is compared with, the most that is said.
  Detail detail_at(std::uint32_t point) const {
    const float threshold = threshold_at(point);
    if (spread_[point] > threshold) return Detail::found;
    if (point >= hierarchy_.level_begin(1)) return detail_of(coefficients_[point], deviation_[point], threshold);
    Detail most = Detail::none;
    hierarchy_.visit_covering(0, hierarchy_.place(point), [&](std::uint32_t other, float) {
      most = std::max(most, detail_of(point_values_[point] - point_values_[other],
                                      std::hypot(deviation_[point], deviation_[other]), threshold));
    });
    return most;
  }

  Detail detail_of(const Rgb& difference, float deviation, float threshold) const {
    const float size = largest_magnitude(difference);
    if (!(size > threshold)) return Detail::none;
    return size > static_cast<float>(rule_.noise_guard) * deviation ? Detail::found : Detail::undecided;
  }

  void find_children(std::uint32_t point, std::vector<std::uint32_t>& found) const {
    const std::uint32_t level = hierarchy_.level_of(point) + 1;
    if (level >= hierarchy_.levels()) return;
    // Beyond a wall, too: this function may reach through it.
    hierarchy_.visit_uncut(level, hierarchy_.place(point), [&](std::uint32_t child, float) {
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

  const Hierarchy& hierarchy_;
  const PointValues& values_;
  const RefinementRule& rule_;
  Task& task_;
  Coefficients point_values_;  ///< the function itself at the computed points
  Coefficients coefficients_;
  std::vector<std::uint8_t> asked_;  ///< computed or about to be
  std::vector<float> deviation_;     ///< of the estimates at the computed points, W/m²
  std::vector<float> spread_;        ///< that what is near may cause within the ball, W/m²
  float threshold_ = 0.0F;           ///< W/m²
  std::uint64_t undecided_ = 0;      ///< points whose differences noise may have made
};

}  // namespace

RgbDouble coarsest_mean(const Coefficients& coefficients) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  RgbDouble sum;
  for (std::uint32_t point = 0; point < hierarchy.level_size(0); ++point)
    sum += hierarchy.coarsest_share(point) * RgbDouble(coefficients[point]);
  return sum;
}

Coefficients approximate(const Hierarchy& hierarchy, const PointValues& values, const RefinementRule& rule, Task& task) {
  Refinement refinement(hierarchy, values, rule, task);
  std::vector<std::uint32_t> wanted = refinement.first_points();
  refinement.compute(wanted);
  refinement.set_threshold();
  while (!task.cancelled()) {
    wanted = refinement.refine(wanted);
    if (wanted.empty()) break;
    refinement.compute(wanted);
  }
  return refinement.finish();
}

}  // namespace gibench::meshless
