/// From sums over the paths of each replicate to a value and the variance of that value.
#pragma once

#include <cstdint>
#include <span>

#include "common/core/rgb.h"

namespace gibench::pathtracer {

/// What the paths of one replicate brought.
struct ReplicateSum {
  RgbDouble direct, indirect;
  std::uint64_t paths = 0;

  void add(const ReplicateSum& other) {
    direct += other.direct, indirect += other.indirect;
    paths += other.paths;
  }
};

struct ValueEstimate {
  RgbDouble direct, indirect;
  RgbDouble direct_variance, indirect_variance, total_variance;  ///< of the means; zero for fewer than two replicates
};

/// The mean over all paths, and its variance from the scatter of the replicates' means m_r over their n_r paths:
/// R/(R−1) Σ (n_r/n)² (m_r − m)², unbiased for equal n_r.
ValueEstimate estimate(std::span<const ReplicateSum> replicates);

}  // namespace gibench::pathtracer
