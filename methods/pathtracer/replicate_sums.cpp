#include "methods/pathtracer/replicate_sums.h"

namespace gibench::pathtracer {

ValueEstimate estimate(std::span<const ReplicateSum> replicates) {
  ReplicateSum all;
  double used = 0.0;
  for (const ReplicateSum& replicate : replicates) {
    all.add(replicate);
    used += replicate.paths > 0 ? 1.0 : 0.0;
  }
  ValueEstimate result;
  if (all.paths == 0) return result;
  const auto total_paths = static_cast<double>(all.paths);
  result.direct = all.direct / total_paths;
  result.indirect = all.indirect / total_paths;
  if (used < 2.0) return result;
  for (const ReplicateSum& replicate : replicates) {
    if (replicate.paths == 0) continue;
    const auto paths = static_cast<double>(replicate.paths);
    const double weight = paths / total_paths;
    const double factor = weight * weight * used / (used - 1.0);
    const RgbDouble direct = replicate.direct / paths - result.direct;
    const RgbDouble indirect = replicate.indirect / paths - result.indirect;
    result.direct_variance += direct * direct * factor;
    result.indirect_variance += indirect * indirect * factor;
    result.total_variance += (direct + indirect) * (direct + indirect) * factor;
  }
  return result;
}

}  // namespace gibench::pathtracer
