#include "bench/record/relight_economics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gibench {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::optional<double> if_finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

}  // namespace

PathTraced at_as_many_points(const PathTraced& traced, std::size_t compared, std::size_t asked) {
  PathTraced scaled = traced;
  scaled.seconds *= static_cast<double>(asked) / static_cast<double>(compared);
  return scaled;
}

Bounded path_tracing_seconds(const PathTraced& traced, const ErrorValue& rmse) {
  if (!(traced.seconds > 0.0) || !(traced.rmse > 0.0) || !std::isfinite(rmse.value)) return {};
  const double one_path = traced.seconds / std::max(1.0, traced.paths);
  const auto seconds_to = [&](double error) -> std::optional<double> {
    if (!(error > 0.0) || !std::isfinite(error)) return std::nullopt;
    return if_finite(std::max(one_path, traced.seconds * std::pow(traced.rmse / error, 2.0)));
  };
  if (!rmse.resolved) return {{}, seconds_to(rmse.high), {}};
  return {seconds_to(rmse.value), seconds_to(rmse.high), seconds_to(rmse.low)};
}

Bounded times_cheaper(const Bounded& path_tracing_seconds, double frame_seconds) {
  if (!(frame_seconds > 0.0)) return {};  // less than the clock resolves
  const auto over = [&](std::optional<double> seconds) {
    return seconds ? std::optional(*seconds / frame_seconds) : std::nullopt;
  };
  return {over(path_tracing_seconds.value), over(path_tracing_seconds.low), over(path_tracing_seconds.high)};
}

Bounded frames_that_pay(double prepare_seconds, double frame_seconds, const Bounded& path_tracing_seconds) {
  const auto frames = [&](std::optional<double> traced) -> std::optional<double> {
    if (!traced || *traced <= frame_seconds) return std::nullopt;
    return std::max(1.0, std::ceil(prepare_seconds / (*traced - frame_seconds)));
  };
  return {frames(path_tracing_seconds.value), frames(path_tracing_seconds.high), frames(path_tracing_seconds.low)};
}

double median_of(std::span<const double> numbers) {
  if (numbers.empty()) return 0.0;
  std::vector<double> sorted(numbers.begin(), numbers.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

Bounded median_of(std::span<const Bounded> numbers) {
  const auto of = [&](std::optional<double> Bounded::*part) -> std::optional<double> {
    std::vector<double> values;
    for (const Bounded& number : numbers) values.push_back((number.*part).value_or(unbounded));
    return values.empty() ? std::nullopt : if_finite(median_of(values));
  };
  Bounded median{of(&Bounded::value), of(&Bounded::low), of(&Bounded::high)};
  return median;
}

}  // namespace gibench
