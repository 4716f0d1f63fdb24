#include "common/lighting/alias_table.h"

#include <algorithm>
#include <numeric>

namespace gibench {

AliasTable::AliasTable(std::span<const double> weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(sum > 0.0)) return;
  const std::size_t count = weights.size();
  entries_.resize(count);
  std::vector<double> scaled(count);
  std::vector<std::uint32_t> small, large;
  for (std::uint32_t i = 0; i < count; ++i) {
    entries_[i].probability = static_cast<float>(weights[i] / sum);
    entries_[i].alias = i;
    scaled[i] = weights[i] / sum * static_cast<double>(count);
    (scaled[i] < 1.0 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t low = small.back();
    const std::uint32_t high = large.back();
    small.pop_back();
    entries_[low].threshold = static_cast<float>(scaled[low]);
    entries_[low].alias = high;
    scaled[high] -= 1.0 - scaled[low];
    if (scaled[high] < 1.0) {
      large.pop_back();
      small.push_back(high);
    }
  }
}

std::uint32_t AliasTable::draw(float u) const {
  const float position = u * static_cast<float>(entries_.size());
  const auto slot = std::min(static_cast<std::uint32_t>(position), static_cast<std::uint32_t>(entries_.size() - 1));
  const Entry& entry = entries_[slot];
  return position - static_cast<float>(slot) < entry.threshold ? slot : entry.alias;
}

}  // namespace gibench
