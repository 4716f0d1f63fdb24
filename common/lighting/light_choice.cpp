#include "common/lighting/light_choice.h"

#include <algorithm>
#include <bit>

#include "common/core/error.h"

namespace gibench {

LightChoice::LightChoice(const std::vector<double>& power, const std::vector<std::uint32_t>& source)
    : probability_(power.size()) {
  GIBENCH_CHECK(power.size() == source.size(), "one source for each light");
  double total = 0.0;
  std::uint32_t source_count = 0;
  for (std::size_t i = 0; i < power.size(); ++i) total += power[i], source_count = std::max(source_count, source[i] + 1);
  if (!(total > 0.0)) return;
  std::vector<double> of_source(source_count);
  for (std::size_t i = 0; i < power.size(); ++i) of_source[source[i]] += power[i];
  const auto lit = static_cast<double>(std::count_if(of_source.begin(), of_source.end(), [](double p) { return p > 0.0; }));

  up_to_.reserve(power.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    const double share = power[i] > 0.0 ? 0.5 * power[i] / total + 0.5 * power[i] / (of_source[source[i]] * lit) : 0.0;
    probability_[i] = static_cast<float>(share);
    up_to_.push_back(sum += share);
  }
  for (double& value : up_to_) value /= sum;

  // A table of about one bin a light makes the search short.
  const auto bits = static_cast<unsigned>(std::clamp(std::bit_width(power.size()), std::size_t{1}, std::size_t{20}));
  bin_shift_ = 32U - bits;
  first_of_bin_.resize(std::size_t{1} << bits);
  for (std::size_t bin = 0; bin < first_of_bin_.size(); ++bin) {
    const double start = static_cast<double>(bin) / static_cast<double>(first_of_bin_.size());
    first_of_bin_[bin] = static_cast<std::uint32_t>(std::upper_bound(up_to_.begin(), up_to_.end(), start) - up_to_.begin());
  }
}

std::size_t LightChoice::choose(std::uint32_t bits) const {
  const double target = static_cast<double>(bits) * 0x1p-32;
  std::size_t light = first_of_bin_[bits >> bin_shift_];
  while (light + 1 < up_to_.size() && up_to_[light] <= target) ++light;
  return light;
}

double LightChoice::rest(std::size_t light, std::uint32_t bits) const {
  const double begin = light == 0 ? 0.0 : up_to_[light - 1];
  return std::clamp((static_cast<double>(bits) * 0x1p-32 - begin) / (up_to_[light] - begin), 0.0, 1.0);
}

}  // namespace gibench
