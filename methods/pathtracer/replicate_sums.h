/// The sums of one value's paths, a sum for each independent replicate: its mean and that mean's variance.
#pragma once

#include <cstdint>
#include <vector>

#include "common/method/method.h"
#include "methods/pathtracer/path_estimator.h"

namespace gibench::pathtracer {

class ReplicateSums {
 public:
  explicit ReplicateSums(std::size_t replicates) : replicates_(replicates) {}

  std::size_t count() const { return replicates_.size(); }
  void add(std::size_t replicate, const PathLight& light);

  /// Writes value `index` of every span that is asked for. The mean is over all paths; the variance of the mean
  /// from the scatter of the replicates' means, weighed by their paths: unbiased for equal numbers of paths. A
  /// single replicate leaves the variances unwritten.
  void write(const ShadeAnswer& answer, std::size_t index) const;

 private:
  struct Sum {
    RgbDouble direct, indirect;
    double paths = 0.0;
  };
  template <class Select>
  Rgb variance(const Select& select) const;
  std::vector<Sum> replicates_;
};

}  // namespace gibench::pathtracer
