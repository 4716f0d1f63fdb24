#include "methods/pathtracer/replicate_sums.h"

namespace gibench::pathtracer {

void ReplicateSums::add(std::size_t replicate, const PathLight& light) {
  Sum& sum = replicates_[replicate];
  sum.direct += RgbDouble(light.direct);
  sum.indirect += RgbDouble(light.indirect);
  sum.paths += 1.0;
}

/// Var of the ratio mean Σ s_r / Σ n_r: R/(R−1) Σ (s_r − n_r m)² / (Σ n_r)².
template <class Select>
Rgb ReplicateSums::variance(const Select& select) const {
  RgbDouble total;
  double paths = 0.0;
  for (const Sum& sum : replicates_) total += select(sum), paths += sum.paths;
  const RgbDouble mean = total / paths;
  RgbDouble scatter;
  for (const Sum& sum : replicates_) {
    const RgbDouble apart = select(sum) - mean * sum.paths;
    scatter += apart * apart;
  }
  const auto count = static_cast<double>(replicates_.size());
  return Rgb(scatter * (count / (count - 1.0) / (paths * paths)));
}

void ReplicateSums::write(const ShadeAnswer& answer, std::size_t index) const {
  Sum all;
  for (const Sum& sum : replicates_) {
    all.direct += sum.direct;
    all.indirect += sum.indirect;
    all.paths += sum.paths;
  }
  if (!answer.direct.empty()) answer.direct[index] = Rgb(all.direct / all.paths);
  if (!answer.indirect.empty()) answer.indirect[index] = Rgb(all.indirect / all.paths);
  if (count() < 2) return;
  if (!answer.direct_variance.empty()) answer.direct_variance[index] = variance([](const Sum& s) { return s.direct; });
  if (!answer.indirect_variance.empty()) answer.indirect_variance[index] = variance([](const Sum& s) { return s.indirect; });
  if (!answer.total_variance.empty()) answer.total_variance[index] = variance([](const Sum& s) { return s.direct + s.indirect; });
}

}  // namespace gibench::pathtracer
