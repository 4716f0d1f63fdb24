#include "methods/antiradiance/interreflection.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/finite_elements/bounce_series.h"
#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/patch_transport.h"

namespace gibench::antiradiance {

namespace {

constexpr double negligible_bounce = 1e-5;    // of the sum so far
constexpr std::size_t most_in_line = 64;      // surfaces, whose negative light is waited for
constexpr double most_inner_residual = 0.03;  // of a bounce, however little of all light it is

FixedPointRule rule_of(const Settings& settings, bool pictures) {
  FixedPointRule rule;
  rule.residual = settings.residual;
  rule.most_iterations = settings.most_iterations;
  if (pictures) rule.exactly = settings.iterations;
  return rule;
}

/// All bounces of the plan, or fewer where one is negligible.
BounceSeries planned(int bounces) { return BounceSeries({bounces, bounces, 0.0}); }
std::string as_planned(int bounces) { return fmt::format("at most {} bounces, as planned", bounces); }

double total(std::span<const Rgb> values) {
  double sum = 0.0;
  for (const Rgb& value : values)
    sum += std::fabs(static_cast<double>(value.r)) + std::fabs(static_cast<double>(value.g)) +
           std::fabs(static_cast<double>(value.b));
  return sum;
}

void take_over(const FixedPointOutcome& from, Interreflection& to) {
  to.iterations += from.applications;
  to.residual = from.residual;
  if (!succeeded(from.termination) || !succeeded(to.termination)) {
    if (succeeded(to.termination)) to.termination = from.termination;
  } else {
    to.termination = from.termination;
  }
  if (!from.message.empty()) to.message = from.message;
}

std::span<const Rgb> as_colours(const Vector& vector) {
  return {reinterpret_cast<const Rgb*>(vector.data()), static_cast<std::size_t>(vector.size()) / 3};
}
std::span<Rgb> as_colours(Vector& vector) {
  return {reinterpret_cast<Rgb*>(vector.data()), static_cast<std::size_t>(vector.size()) / 3};
}

/// Links that carry visibility themselves: one irradiance a leaf.
class Patches {
 public:
  Patches(const Discretisation& parts, const Linking& linking, const Surfaces& surfaces, Task& task)
      : transport_(parts.hierarchy, linking.links), surfaces_(surfaces), task_(task) {}

  /// s U of radiosities.
  void transport(std::span<const Rgb> radiosity, std::span<Rgb> arriving) {
    transport_.transport(radiosity, {}, arriving, task_);
    for (std::size_t i = 0; i < arriving.size(); ++i) arriving[i] *= surfaces_.closure[i];
  }

  Interreflection solve(std::span<const Rgb> direct, const FixedPointRule& rule) {
    Interreflection result;
    Vector first(static_cast<Eigen::Index>(3 * direct.size()));
    transport(products(direct, surfaces_.albedo), as_colours(first));
    const LinearMap bounce = [this](const Vector& in, Vector& out) {
      transport(products(as_colours(in), surfaces_.albedo), as_colours(out));
    };
    Vector sum;
    if (surfaces_.max_bounces) sum = bounded(first, bounce, *surfaces_.max_bounces, result);
    else take_over(solve_fixed_point(first, bounce, rule, sum, task_), result);
    const auto colours = as_colours(sum);
    result.irradiance.assign(colours.begin(), colours.end());
    return result;
  }

 private:
  Vector bounded(const Vector& first, const LinearMap& bounce, int bounces, Interreflection& result) {
    Vector sum = first, term = first, next(first.size());
    BounceSeries series = planned(bounces);
    series.add();
    while (series.goes_on() && !task_.cancelled()) {
      bounce(term, next);
      term.swap(next);
      sum += term;
      ++result.iterations;
      series.add();
      task_.progress(fmt::format("bounce {}", series.bounces()), static_cast<double>(series.bounces()) / bounces);
      if (static_cast<double>(term.norm()) <= negligible_bounce * static_cast<double>(sum.norm())) series.settle();
    }
    result.termination = Termination::bound_reached;
    result.message = as_planned(bounces);
    return sum;
  }

  PatchTransport transport_;
  const Surfaces& surfaces_;
  Task& task_;
};

/// Light by direction, negative light in place of visibility.
class Directions {
 public:
  Directions(const Discretisation& parts, const Linking& linking, const Surfaces& surfaces, Task& task)
      : hierarchy_(parts.hierarchy),
        transport_(parts.hierarchy, linking.links, *linking.bins),
        surfaces_(surfaces),
        reflection_{surfaces.albedo, surfaces.closure, surfaces.glossy},
        task_(task) {}

  Interreflection solve(std::span<const Rgb> direct, const FixedPointRule& rule) {
    Interreflection result;
    Vector first, sum;
    transport_.transport_sources(products(direct, surfaces_.albedo), surfaces_.glossy_direct, first, task_);
    result.irradiance.assign(direct.size(), Rgb());
    if (surfaces_.max_bounces) {
      bounded(first, rule, *surfaces_.max_bounces, sum, result);
    } else {
      all_bounces(first, rule, sum, result);
    }
    if (surfaces_.keeps_directions) result.by_direction = std::move(sum);
    return result;
  }

  /// Why negative light may not come to an end here, and what to do about it.
  std::string why_not() {
    std::vector<float> depths = transport_.depths(task_);
    double sum = 0.0, area = 0.0;
    for (std::size_t leaf = 0; leaf < depths.size(); ++leaf) {
      const auto own = static_cast<double>(hierarchy_.nodes()[hierarchy_.leaf_node(leaf)].area);
      sum += own * static_cast<double>(depths[leaf]), area += own;
    }
    return fmt::format(
        "negative light does not come to an end, with {:.1f} surfaces one behind another in the mean before an element, {:.1f} "
        "at "
        "most: use mode=radiosity or mode=implicit, or raise the parameter most_iterations",
        area > 0.0 ? sum / area : 0.0, depths.empty() ? 0.0F : *std::max_element(depths.begin(), depths.end()));
  }

  /// Irradiance under radiosity 1 on every front.
  std::vector<Rgb> uniform(const FixedPointRule& rule, Interreflection& result) {
    Vector first, sum;
    const std::vector<Rgb> ones(surfaces_.closure.size(), Rgb(1.0F));
    transport_.transport_sources(ones, {}, first, task_);
    take_over(solve_fixed_point(first, through(), in_line(rule), sum, task_), result);
    std::vector<Rgb> fronts(ones.size());
    add_fronts(sum, fronts);
    return fronts;
  }

 private:
  /// For light that is only taken away.
  static FixedPointRule in_line(FixedPointRule rule) {
    rule.patience = most_in_line;
    rule.rounding = 0.5 / static_cast<double>(most_units);
    return rule;
  }

  LinearMap through() {
    return [this](const Vector& in, Vector& out) { transport_.transport_through(in, out, task_); };
  }

  /// All at once, bounces and what takes light away; where that grows, bounce by bounce: see README.md, Iteration.
  void all_bounces(Vector& first, const FixedPointRule& rule, Vector& sum, Interreflection& result) {
    const LinearMap everything = [this](const Vector& in, Vector& out) { transport_.transport(in, reflection_, out, task_); };
    FixedPointRule at_once = rule;
    at_once.series_only = true;
    const FixedPointOutcome outcome = solve_fixed_point(first, everything, at_once, sum, task_);
    if (succeeded(outcome.termination) || task_.cancelled()) {
      take_over(outcome, result);
      add_fronts(sum, result.irradiance);
      return;
    }
    result.iterations += outcome.applications;
    BounceSeries series({{}, rule.most_iterations, rule.residual});
    one_by_one(first, rule, series, {rule.residual, true}, sum, result);
    const std::string how = outcome.message + " with all bounces at once";
    if (!succeeded(result.termination)) {
      result.message = fmt::format("{} ({}; bounce by bounce {})", why_not(), how, result.message);
    } else if (series.settled()) {
      result.message = fmt::format("{}; it converged bounce by bounce, {} of them", how, series.bounces());
    } else {
      result.termination = Termination::not_converged;
      result.message = fmt::format("{}; {} bounces one by one did not end", how, series.bounces());
    }
  }

  void bounded(Vector& arriving, const FixedPointRule& rule, int bounces, Vector& sum, Interreflection& result) {
    BounceSeries series = planned(bounces);
    one_by_one(arriving, rule, series, {negligible_bounce, false}, sum, result);
    if (succeeded(result.termination)) result.termination = Termination::bound_reached;
    if (result.message.empty()) result.message = as_planned(bounces);
  }

  /// How closely bounces are solved for one by one.
  struct BounceRule {
    double negligible;  ///< the last bounce is at most this share of all
    /// A bounce that is a small share of all light is solved for only so far that its residual is as small a share of all light.
    bool loosens;
  };

  /// Each bounce without what is hidden from it, before the next is made of it: until one is a negligible share of all.
  void one_by_one(Vector& arriving, const FixedPointRule& rule, BounceSeries& series, const BounceRule& how, Vector& sum,
                  Interreflection& result) {
    Vector bounce;
    double so_far = 0.0;
    FixedPointRule own = in_line(rule);
    while (series.goes_on() && !task_.cancelled()) {
      if (series.bounces() > 0) transport_.transport_reflected(bounce, reflection_, arriving, task_);
      take_over(solve_fixed_point(arriving, through(), own, bounce, task_), result);
      if (!succeeded(result.termination)) return;
      std::vector<Rgb> fronts(result.irradiance.size());
      add_fronts(bounce, fronts);
      for (std::size_t i = 0; i < fronts.size(); ++i) result.irradiance[i] += fronts[i];
      if (series.bounces() == 0) sum = bounce;
      else sum += bounce;
      series.add();
      const double size = total(fronts);
      so_far += size;
      const double share = so_far > 0.0 ? size / so_far : 0.0;
      task_.progress(fmt::format("bounce {}", series.bounces()), progress_of(share, how.negligible), share);
      if (size <= how.negligible * so_far) series.settle();
      // For the next bounce, which is a smaller share of all light than this one.
      if (how.loosens && share > 0.0)
        own.residual = std::max(rule.residual, std::min(most_inner_residual, rule.residual / share));
    }
  }

  void add_fronts(const Vector& arriving, std::vector<Rgb>& fronts) {
    transport_.irradiance(arriving, fronts, task_);
    for (std::size_t i = 0; i < fronts.size(); ++i) fronts[i] *= surfaces_.closure[i];
  }

  const Hierarchy& hierarchy_;
  BinTransport transport_;
  const Surfaces& surfaces_;
  Reflection reflection_;
  Task& task_;
};

}  // namespace

std::vector<Rgb> products(std::span<const Rgb> a, std::span<const Rgb> b) {
  std::vector<Rgb> result(a.begin(), a.end());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= b[i];
  return result;
}

Closure closure_factors(const Discretisation& parts, const Linking& linking, const Settings& settings, Task& task) {
  const std::size_t leaves = parts.hierarchy.leaf_count();
  Closure result;
  Surfaces white;
  white.albedo.assign(leaves, Rgb(1.0F));
  white.closure.assign(leaves, 1.0F);
  if (linking.visibility == Visibility::shadow_passes) {
    result.factors = std::move(white.closure);
    return result;
  }
  std::vector<Rgb> response(leaves);
  if (linking.visibility == Visibility::antiradiance) {
    Interreflection ended;
    Directions directions(parts, linking, white, task);
    response = directions.uniform(rule_of(settings, false), ended);
    result.iterations = ended.iterations;
    if (!ended.message.empty()) result.message = "negative light of uniform surfaces: " + ended.message;
    if (!succeeded(ended.termination)) {
      result.termination = ended.termination;
      if (!task.cancelled()) result.message = fmt::format("{} ({})", directions.why_not(), result.message);
      return result;
    }
  } else {
    Patches(parts, linking, white, task).transport(white.albedo, response);
  }
  std::vector<float> sums, closed;
  for (const Rgb& value : response) sums.push_back(value.g);
  if (settings.closure_rays > 0)
    for (const std::uint32_t element : parts.hierarchy.order()) closed.push_back(parts.surroundings.closed[element]);
  result.factors = normalisation(sums, closed);
  return result;
}

Interreflection interreflect(const Discretisation& parts, const Linking& linking, const Settings& settings,
                             const Surfaces& surfaces, std::span<const Rgb> direct, Task& task) {
  if (linking.visibility == Visibility::antiradiance)
    return Directions(parts, linking, surfaces, task).solve(direct, rule_of(settings, true));
  return Patches(parts, linking, surfaces, task).solve(direct, rule_of(settings, true));
}

}  // namespace gibench::antiradiance
