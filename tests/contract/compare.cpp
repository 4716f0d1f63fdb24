#include "tests/contract/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace gibench::contract {

namespace {

using Indices = std::vector<std::size_t>;

/// All samples, and those of each object that has enough of them.
std::map<std::string, Indices> groups_of(const std::vector<SurfaceSample>& samples) {
  std::map<std::string, Indices> groups;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    groups["all"].push_back(i);
    groups["object " + std::to_string(samples[i].object)].push_back(i);
  }
  std::erase_if(groups, [](const auto& group) { return group.second.size() < fewest_samples; });
  return groups;
}

struct Difference {
  double mean = 0.0, standard_error = 0.0;
};

/// Of `test` - `base` over these samples.
Difference difference(const std::vector<Rgb>& base, const std::vector<Rgb>& test, const Indices& at, int channel) {
  const auto count = static_cast<double>(at.size());
  double sum = 0.0, squares = 0.0;
  const auto of = [&](std::size_t i) { return static_cast<double>(test[i][channel]) - static_cast<double>(base[i][channel]); };
  for (const std::size_t i : at) sum += of(i);
  const double mean = sum / count;
  for (const std::size_t i : at) squares += (of(i) - mean) * (of(i) - mean);
  return {mean, std::sqrt(squares / (count * (count - 1.0)))};
}

/// Calls found(group, channel, difference, share of the scene's mean) for every mean that is compared.
template <class Found>
void each_mean(const std::vector<Rgb>& base, const std::vector<Rgb>& test, const std::vector<SurfaceSample>& samples,
               const Found& found) {
  const RgbDouble scene_mean = mean_of(base);
  for (const auto& [name, at] : groups_of(samples))
    for (int channel = 0; channel < 3; ++channel) found(name, channel, difference(base, test, at, channel), scene_mean[channel]);
}

void require_multiple(const std::vector<Rgb>& base, const std::vector<Rgb>& test, double factor, const std::string& what) {
  const RgbDouble mean = mean_of(base);
  for (std::size_t i = 0; i < base.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = factor * static_cast<double>(base[i][channel]), found = static_cast<double>(test[i][channel]);
      const double tolerance = rounding_of_value * std::fabs(expected) + rounding_of_mean * factor * std::fabs(mean[channel]);
      if (!(std::fabs(found - expected) <= tolerance))
        throw Violation(fmt::format("{} of sample {}, channel {}: {} where {} was due", what, i, channel, found, expected));
    }
}

void require_same_means(const std::vector<Rgb>& base, const std::vector<Rgb>& test, const std::vector<SurfaceSample>& samples,
                        double slack, const std::string& what) {
  each_mean(base, test, samples, [&](const std::string& group, int channel, const Difference& d, double scene_mean) {
    if (!(std::fabs(d.mean) <= standard_errors * d.standard_error + slack * std::fabs(scene_mean)))
      throw Violation(fmt::format("{}, mean over {}, channel {}: differs by {} ± {} where the scene's mean is {}", what, group,
                                  channel, d.mean, d.standard_error, scene_mean));
  });
}

void require_same_bits(const std::vector<Rgb>& base, const std::vector<Rgb>& test, const std::string& what) {
  for (std::size_t i = 0; i < base.size(); ++i)
    if (std::memcmp(&base[i], &test[i], sizeof(Rgb)) != 0)
      throw Violation(fmt::format("{} of sample {}: ({}, {}, {}) and then ({}, {}, {})", what, i, base[i].r, base[i].g, base[i].b,
                                  test[i].r, test[i].g, test[i].b));
}

}  // namespace

Slack slack_of(const MethodEntry& entry) {
  const Capabilities can = make_session(entry, Parameters(entry.schema, entry.quick))->capabilities();
  Slack slack;
  if (can.variance) return slack;
  slack.indirect = placement_share;
  if (can.direct) slack.direct = placement_share;
  return slack;
}

RgbDouble mean_of(const std::vector<Rgb>& values) {
  RgbDouble sum;
  for (const Rgb& value : values) sum += RgbDouble(value);
  return values.empty() ? sum : sum / static_cast<double>(values.size());
}

void require_multiple(const Answer& base, const Answer& test, double factor, const std::string& what) {
  require_multiple(base.direct, test.direct, factor, what + ", direct light");
  require_multiple(base.indirect, test.indirect, factor, what + ", indirect light");
}

void require_same_means(const Answer& base, const Answer& test, const std::vector<SurfaceSample>& samples, const Slack& slack,
                        const std::string& what) {
  require_same_means(base.direct, test.direct, samples, slack.direct, what + ", direct light");
  require_same_means(base.indirect, test.indirect, samples, slack.indirect, what + ", indirect light");
}

void require_no_less(const std::vector<Rgb>& less, const std::vector<Rgb>& more, const std::vector<SurfaceSample>& samples,
                     double slack, const std::string& what) {
  each_mean(less, more, samples, [&](const std::string& group, int channel, const Difference& d, double scene_mean) {
    if (!(d.mean >= -standard_errors * d.standard_error - slack * std::fabs(scene_mean)))
      throw Violation(fmt::format("{}, mean over {}, channel {}: falls by {} ± {} where the scene's mean is {}", what, group,
                                  channel, -d.mean, d.standard_error, scene_mean));
  });
}

void require_same_bits(const Answer& base, const Answer& test, const std::string& what) {
  require_same_bits(base.direct, test.direct, what + ", direct light");
  require_same_bits(base.indirect, test.indirect, what + ", indirect light");
}

void require_black(const std::vector<Rgb>& values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] == Rgb()))
      throw Violation(fmt::format("{} of sample {} is ({}, {}, {}) where nothing can arrive", what, i, values[i].r, values[i].g,
                                  values[i].b));
}

void require_sane(const std::vector<Rgb>& values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_finite(values[i])) throw Violation(fmt::format("{} of sample {} is not finite", what, i));
  const RgbDouble mean = mean_of(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      if (!(static_cast<double>(values[i][channel]) >= -ringing_share * std::fabs(mean[channel])))
        throw Violation(fmt::format("{} of sample {}, channel {} is {}: below zero", what, i, channel, values[i][channel]));
}

}  // namespace gibench::contract
