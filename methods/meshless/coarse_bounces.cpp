#include "methods/meshless/coarse_bounces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "common/method/series_termination.h"
#include "methods/meshless/fit.h"
#include "methods/meshless/near_hits.h"
#include "methods/meshless/transport_rows.h"

namespace gibench::meshless {

namespace {

constexpr int gather_number = 1;  // of the one gather that there is
constexpr int most_rounds = 8;    // of what detail changes in detail

/// Σ |c| over the points that have one.
double magnitude(const Coefficients& coefficients) {
  double sum = 0.0;
  for (const std::uint32_t point : coefficients.sorted_points()) {
    const Rgb value = coefficients[point];
    sum += std::fabs(static_cast<double>(value.r)) + std::fabs(static_cast<double>(value.g)) +
           std::fabs(static_cast<double>(value.b));
  }
  return sum;
}

class CoarseBounces {
 public:
  CoarseBounces(LightAtPoints& light, const Transport& transport, const Coefficients* direct, const Settings& settings,
                const SeriesBound& bound, Task& task)
      : light_(light),
        hierarchy_(transport.hierarchy),
        direct_(direct),
        settings_(settings),
        bound_(bound),
        task_(task),
        levels_(coarse_levels(hierarchy_, settings)),
        rows_(hierarchy_, transport.groups, levels_, settings.epsilon_omega, light.channels()),
        near_hits_(hierarchy_, transport.groups, levels_, settings.epsilon_omega, task.seed()) {}

  IndirectLight solve() {
    const bool single = bound_.bounces.last() == 1;
    gather_first_bounce(!single);
    BounceSum bounces(fitted(first_), bound_, settings_.residual, task_);
    // The last bounce of all is the final gather's own.
    while (bounces.series().goes_on() && bounces.series().next() < bound_.bounces.last() && !task_.cancelled())
      bounces.add(fitted(rows_.apply(bounces.last(), task_)));
    task_.count("coarse_functions", rows_.size());
    task_.count("coarse_links", rows_.links());
    if (!single && !task_.cancelled()) bounces.add_unsummed();
    const BounceSeries& series = bounces.series();
    task_.count("bounces", static_cast<std::uint64_t>(series.bounces()));
    if (task_.cancelled()) return {bounces.sum(), Termination::cancelled, {}};
    IndirectLight all{single ? final_gather(nullptr) : final_gather(&bounces.sum()), termination_of(series), series.message()};
    if (!single && !task_.cancelled()) add_missed_detail(all.coefficients, share_sent(bounces));
    return all;
  }

 private:
  void gather_first_bounce(bool keep_rows) {
    std::vector<std::uint32_t> points(rows_.size());
    std::iota(points.begin(), points.end(), 0U);
    first_.resize(points.size());
    if (keep_rows) keepers_ = {&near_hits_, &rows_};
    if (direct_ != nullptr) light_.gather(light_.sender_of(*direct_), gather_number, points, first_, keepers_);
    else light_.gather(light_.direct_sender(), gather_number, points, first_, keepers_);
    if (keep_rows) keepers_.pop_back();
  }

  Coefficients fitted(const std::vector<Estimate>& values) const {
    Coefficients at_points(hierarchy_, light_.channels());
    for (std::uint32_t point = 0; point < values.size(); ++point) at_points.set(point, values[point].value);
    return fit(at_points, settings_.corrections, task_);
  }

  /// All bounces, from direct light and those solved so far.
  Coefficients final_gather(const Coefficients* solved) {
    std::vector<Estimate> coarse = first_;
    if (solved != nullptr) {
      const std::vector<Estimate> later = rows_.apply(*solved, task_);
      for (std::size_t point = 0; point < coarse.size(); ++point) {
        coarse[point].value += later[point].value;
        coarse[point].deviation = std::hypot(coarse[point].deviation, later[point].deviation);
      }
    }
    if (direct_ == nullptr) {
      const DirectSender first = light_.direct_sender();
      if (solved == nullptr) return refined(coarse, first);
      return refined(coarse, BothSenders(first, light_.sender_of(*solved)));
    }
    if (solved == nullptr) return refined(coarse, light_.sender_of(*direct_));
    Coefficients all = *direct_;
    add_scaled(all, *solved, Rgb(1.0F));
    return refined(coarse, light_.sender_of(all));
  }

  /// Coarse points have their values already.
  Coefficients refined(const std::vector<Estimate>& coarse, const Sender& sender) {
    RefinementRule rule = light_.rule();
    rule.full_level = levels_ - 1;
    const PointValues values = [&](std::span<const std::uint32_t> points, std::span<Estimate> out) {
      const auto fine = std::lower_bound(points.begin(), points.end(), rows_.size());
      const auto known = static_cast<std::size_t>(fine - points.begin());
      for (std::size_t i = 0; i < known; ++i) out[i] = coarse[points[i]];
      light_.gather(sender, gather_number, points.subspan(known), out.subspan(known), keepers_);
    };
    Coefficients made = approximate(hierarchy_, values, rule, task_);
    task_.count("basis_functions", made.size());
    return made;
  }

  /// Of the bounces in the solution, those that the final gather was sent: all but the last, which is nothing where the series
  /// ended by itself.
  double share_sent(const BounceSum& bounces) const {
    if (bounces.series().bounces() < bound_.bounces.last()) return 1.0;
    const double sent = channel_mean(coarsest_mean(bounces.sum()));
    const double last = channel_mean(coarsest_mean(fitted(rows_.apply(bounces.last(), task_))));
    return sent > 0.0 ? sent / (sent + last) : 0.0;
  }

  /// The final gather saw the coarse levels alone; what its near hits missed of the others is added, and what that changes in
  /// turn.
  void add_missed_detail(Coefficients& solution, double share) {
    Coefficients detail(hierarchy_, light_.channels());
    for (const std::uint32_t point : solution.sorted_points())
      if (point >= rows_.size()) detail.set(point, solution[point] * static_cast<float>(share));
    task_.count("near_hits", near_hits_.size());
    const int rounds = std::min(most_rounds, bound_.bounces.last() - 1);
    for (int round = 0; round < rounds && !task_.cancelled(); ++round) {
      detail = fit(near_hits_.arriving(detail, task_), settings_.corrections, task_);
      add_scaled(solution, detail, Rgb(1.0F));
      if (!(magnitude(detail) > settings_.residual * magnitude(solution))) break;
      task_.count("detail_rounds", 1);
    }
  }

  LightAtPoints& light_;
  const Hierarchy& hierarchy_;
  const Coefficients* direct_;
  const Settings& settings_;
  const SeriesBound& bound_;
  Task& task_;
  std::uint32_t levels_;  ///< that bounces are solved on
  TransportRows rows_;
  NearHits near_hits_;
  std::vector<HitKeeper*> keepers_;  ///< of the gathers to come
  std::vector<Estimate> first_;      ///< the first bounce at the coarse points
};

}  // namespace

IndirectLight coarse_bounces(LightAtPoints& light, const Transport& transport, const Coefficients* direct,
                             const Settings& settings, const SeriesBound& bound, Task& task) {
  return CoarseBounces(light, transport, direct, settings, bound, task).solve();
}

}  // namespace gibench::meshless
