/// The tolerances of the contract, each with its reason: when two answers count as the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/ray/world.h"
#include "tests/contract/run.h"

namespace gibench::contract {

/// Share of a value, and of the mean of its set: lights that are multiplied by a power of two round nothing, so
/// that only sums in another order may differ.
inline constexpr double rounding_of_value = 1e-4, rounding_of_mean = 1e-5;

/// Standard errors of a mean difference. About 500 means of twenty values and more are compared in all: at five
/// standard errors one of them strays in a hundred sets of seeds.
inline constexpr double standard_errors = 5.0;
/// Share of the scene's mean by which two means may also differ: methods with elements of finite size place
/// them anew when the scene is turned, scaled or lit otherwise, and two placements differ by their own error.
inline constexpr double placement_share = 0.03;
/// The same where nothing is placed: answers that differ by their rounding alone have no scatter that would allow for it.
inline constexpr double rounding_of_means = 1e-4;
/// Samples of one object below which no mean is taken.
inline constexpr std::size_t fewest_samples = 20;

/// Share of the scene's mean that a value may lie below zero: differences of levels and of bounces ring.
inline constexpr double ringing_share = 0.01;
/// Share of a full run's rays that may still be traced once a run is cancelled: the chunks under way.
inline constexpr double late_share = 0.1;

/// What two means may differ by beyond their noise, share of the scene's mean.
struct Slack {
  double direct = rounding_of_means, indirect = rounding_of_means;
};
/// Of a method: its placement's where it has one. A method that knows the variance of its answers has no other error, and direct
/// light that a method leaves to the shared evaluator is estimated at the samples themselves.
Slack slack_of(const MethodEntry& entry);

// Each throws Violation, naming `what` was compared.

/// Every value of `test` is `factor` times that of `base`.
void require_multiple(const Answer& base, const Answer& test, double factor, const std::string& what);
/// The means over each object's samples and over all agree. Answers of one seed are taken pair by pair, so that
/// noise they share falls out.
void require_same_means(const Answer& base, const Answer& test, const std::vector<SurfaceSample>& samples, const Slack& slack,
                        const std::string& what);
/// The means of `more` are nowhere below those of `less` by more than the share `slack` of the scene's mean.
void require_no_less(const std::vector<Rgb>& less, const std::vector<Rgb>& more, const std::vector<SurfaceSample>& samples,
                     double slack, const std::string& what);
void require_same_bits(const Answer& base, const Answer& test, const std::string& what);
void require_black(const std::vector<Rgb>& values, const std::string& what);
/// Finite, and not below zero by more than ringing.
void require_sane(const std::vector<Rgb>& values, const std::string& what);

RgbDouble mean_of(const std::vector<Rgb>& values);

}  // namespace gibench::contract
