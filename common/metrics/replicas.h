/// Independent replicates of the same estimate: what honest intervals are made from.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// `replicas[r][i]` is the estimate of value i by replicate r; all replicates used the same number of samples.
struct Replicas {
  std::vector<std::vector<Rgb>> replicas;

  std::size_t count() const { return replicas.size(); }
  std::size_t size() const { return replicas.empty() ? 0 : replicas.front().size(); }
  /// Mean over all replicates.
  std::vector<Rgb> mean() const;
  /// Mean over the even (which = 0, half A) or odd (1, half B) replicates.
  std::vector<Rgb> half(int which) const;
  /// Mean over the replicates first, first + step, …; of more than `first` replicates.
  std::vector<Rgb> every(std::size_t step, std::size_t first) const;
  /// Mean without one of `groups` groups; replicate r is in group r mod groups. For the delete-one (groups = count())
  /// and delete-a-group jackknife.
  std::vector<Rgb> mean_without(std::size_t left_out, std::size_t groups) const;
  /// Variance of mean() per value and channel: the sample variance over replicates divided by their count.
  std::vector<Rgb> variance_of_mean() const;
  /// Replicate by replicate sum, as for total = direct + indirect. Shapes must agree.
  static Replicas sum(const Replicas& a, const Replicas& b);
};

/// Root mean square of the standard errors over the root mean square of the values, over values and channels: what the
/// reference's own noise is, as a share. Empty without values, with under two replicates, or where all values are 0.
std::optional<double> relative_standard_error(const Replicas& replicas);

}  // namespace gibench
