#include "methods/antiradiance/interreflection.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/finite_elements/bounce_series.h"
#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/patch_transport.h"

namespace gibench::antiradiance {

namespace {

constexpr double negligible_bounce = 1e-5;  // of the sum so far

FixedPointRule rule_of(const Settings& settings, bool pictures) {
  return {settings.residual, settings.most_iterations, pictures ? settings.iterations : 0};
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
      : transport_(parts.hierarchy, linking.links, *linking.bins),
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
      const LinearMap everything = [this](const Vector& in, Vector& out) { transport_.transport(in, reflection_, out, task_); };
      take_over(solve_fixed_point(first, everything, rule, sum, task_), result);
      add_fronts(sum, result.irradiance);
    }
    if (surfaces_.keeps_directions) result.by_direction = std::move(sum);
    return result;
  }

  /// Irradiance under radiosity 1 on every front.
  std::vector<Rgb> uniform(const FixedPointRule& rule, Interreflection& result) {
    Vector first, sum;
    const std::vector<Rgb> ones(surfaces_.closure.size(), Rgb(1.0F));
    transport_.transport_sources(ones, {}, first, task_);
    take_over(solve_fixed_point(first, through(), rule, sum, task_), result);
    std::vector<Rgb> fronts(ones.size());
    add_fronts(sum, fronts);
    return fronts;
  }

 private:
  LinearMap through() {
    return [this](const Vector& in, Vector& out) { transport_.transport_through(in, out, task_); };
  }

  void bounded(Vector& arriving, const FixedPointRule& rule, int bounces, Vector& sum, Interreflection& result) {
    Vector bounce;
    double so_far = 0.0;
    BounceSeries series = planned(bounces);
    while (series.goes_on() && !task_.cancelled()) {
      if (series.bounces() > 0) transport_.transport_reflected(bounce, reflection_, arriving, task_);
      take_over(solve_fixed_point(arriving, through(), rule, bounce, task_), result);
      std::vector<Rgb> fronts(result.irradiance.size());
      add_fronts(bounce, fronts);
      for (std::size_t i = 0; i < fronts.size(); ++i) result.irradiance[i] += fronts[i];
      if (series.bounces() == 0) sum = bounce;
      else sum += bounce;
      series.add();
      const double size = total(fronts);
      so_far += size;
      if (size <= negligible_bounce * so_far) series.settle();
    }
    if (succeeded(result.termination)) result.termination = Termination::bound_reached;
    if (result.message.empty()) result.message = as_planned(bounces);
  }

  void add_fronts(const Vector& arriving, std::vector<Rgb>& fronts) {
    transport_.irradiance(arriving, fronts, task_);
    for (std::size_t i = 0; i < fronts.size(); ++i) fronts[i] *= surfaces_.closure[i];
  }

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
    response = Directions(parts, linking, white, task).uniform(rule_of(settings, false), ended);
    result.iterations = ended.iterations;
    if (!ended.message.empty()) result.message = "negative light of uniform surfaces: " + ended.message;
    if (!succeeded(ended.termination)) {
      result.termination = ended.termination;
      result.message += "; raise the parameter most_iterations, elements or bins";
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
