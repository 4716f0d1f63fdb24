#include "common/metrics/replicas.h"

#include <cmath>

#include "common/core/error.h"
#include "common/core/parallel.h"

namespace gibench {

namespace {

constexpr std::size_t chunk_size = 16384;

void check_shape(const Replicas& set) {
  for (const std::vector<Rgb>& replica : set.replicas)
    GIBENCH_CHECK(replica.size() == set.size(), "all replicates estimate the same values");
}

/// Mean over the replicates first, first + stride, …
std::vector<Rgb> mean_of(const Replicas& set, std::size_t first, std::size_t stride) {
  GIBENCH_CHECK(first < set.count(), "a mean needs a replicate");
  check_shape(set);
  std::vector<Rgb> mean(set.size());
  const double members = static_cast<double>((set.count() - first + stride - 1) / stride);
  parallel_chunks(0, mean.size(), chunk_size, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      RgbDouble sum;
      for (std::size_t r = first; r < set.count(); r += stride) sum += RgbDouble(set.replicas[r][i]);
      mean[i] = Rgb(sum / members);
    }
  });
  return mean;
}

}  // namespace

std::vector<Rgb> Replicas::mean() const { return mean_of(*this, 0, 1); }

std::vector<Rgb> Replicas::half(int which) const {
  GIBENCH_CHECK(which == 0 || which == 1, "there are two halves");
  return mean_of(*this, static_cast<std::size_t>(which), 2);
}

std::vector<Rgb> Replicas::every(std::size_t step, std::size_t first) const {
  GIBENCH_CHECK(step > 0, "a step goes on");
  return mean_of(*this, first, step);
}

std::vector<Rgb> Replicas::mean_without(std::size_t left_out, std::size_t groups) const {
  GIBENCH_CHECK(left_out < groups && groups <= count() && count() > 1, "some replicates remain");
  check_shape(*this);
  std::vector<Rgb> mean(size());
  double members = 0.0;
  for (std::size_t r = 0; r < count(); ++r) members += r % groups == left_out ? 0.0 : 1.0;
  parallel_chunks(0, mean.size(), chunk_size, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      RgbDouble sum;
      for (std::size_t r = 0; r < count(); ++r)
        if (r % groups != left_out) sum += RgbDouble(replicas[r][i]);
      mean[i] = Rgb(sum / members);
    }
  });
  return mean;
}

std::vector<Rgb> Replicas::variance_of_mean() const {
  GIBENCH_CHECK(count() >= 2, "a variance needs two replicates");
  check_shape(*this);
  const double members = static_cast<double>(count());
  std::vector<Rgb> variance(size());
  parallel_chunks(0, variance.size(), chunk_size, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      RgbDouble sum, squares;
      for (const std::vector<Rgb>& replica : replicas) sum += RgbDouble(replica[i]);
      const RgbDouble mean = sum / members;
      for (const std::vector<Rgb>& replica : replicas) {
        const RgbDouble deviation = RgbDouble(replica[i]) - mean;
        squares += deviation * deviation;
      }
      variance[i] = Rgb(squares / (members * (members - 1.0)));
    }
  });
  return variance;
}

Replicas Replicas::sum(const Replicas& a, const Replicas& b) {
  GIBENCH_CHECK(a.count() == b.count() && a.size() == b.size(), "replicates to add have one shape");
  check_shape(a);
  check_shape(b);
  Replicas total = a;
  for (std::size_t r = 0; r < a.count(); ++r)
    for (std::size_t i = 0; i < a.size(); ++i) total.replicas[r][i] += b.replicas[r][i];
  return total;
}

std::optional<double> relative_standard_error(const Replicas& replicas) {
  if (replicas.size() == 0 || replicas.count() < 2) return std::nullopt;
  const std::vector<Rgb> mean = replicas.mean(), variance = replicas.variance_of_mean();
  RgbDouble squares, variances;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    squares += RgbDouble(mean[i]) * RgbDouble(mean[i]);
    variances += RgbDouble(variance[i]);
  }
  const double values = squares.r + squares.g + squares.b;
  if (!(values > 0.0)) return std::nullopt;
  return std::sqrt((variances.r + variances.g + variances.b) / values);
}

}  // namespace gibench
