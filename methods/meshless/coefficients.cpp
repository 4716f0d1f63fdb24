#include "methods/meshless/coefficients.h"

#include <algorithm>

namespace gibench::meshless {

void Coefficients::set(std::uint32_t point, const Rgb& value) {
  if (!has(point)) {
    slot_[point] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    values_.resize(values_.size() + channels_);
  }
  for (std::uint32_t channel = 0; channel < channels_; ++channel)
    values_[std::size_t{channels_} * slot_[point] + channel] = value[static_cast<int>(channel)];
}

std::vector<std::uint32_t> Coefficients::sorted_points() const {
  std::vector<std::uint32_t> sorted = points_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Rgb Coefficients::evaluate(const Place& at, std::uint32_t last_level) const {
  Rgb sum;
  for (std::uint32_t level = 0; level <= last_level; ++level) {
    Rgb weighted;
    float weights = 0.0F;
    hierarchy_->visit_covering(level, at, [&](std::uint32_t point, float w) {
      weights += w;
      if (has(point)) weighted += w * value_in(slot_[point]);
    });
    if (weights > 0.0F) sum += weighted / weights;
  }
  return sum;
}

}  // namespace gibench::meshless
