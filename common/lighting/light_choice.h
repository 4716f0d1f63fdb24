/// The choice of the light that a sample goes to: a fixed probability for every light.
#pragma once

#include <cstdint>
#include <vector>

namespace gibench {

/// Half of the probability goes by power, half evenly over the sources (an emitting object is one source, its triangles
/// share by power): a faint lamp in a closed room keeps its samples beside a sun.
class LightChoice {
 public:
  /// power: W of every light; source: which source each belongs to, numbered from 0. A light without power is never chosen.
  LightChoice(const std::vector<double>& power, const std::vector<std::uint32_t>& source);

  bool empty() const { return up_to_.empty(); }
  float probability(std::size_t light) const { return probability_[light]; }
  /// `bits`: a 32-bit fraction of one.
  std::size_t choose(std::uint32_t bits) const;
  /// Where in the light's own share of [0, 1) the fraction lies, in [0, 1].
  double rest(std::size_t light, std::uint32_t bits) const;

 private:
  std::vector<double> up_to_;  ///< cumulative; empty where there is no power at all
  std::vector<float> probability_;
  std::vector<std::uint32_t> first_of_bin_;  ///< where to begin looking, by the leading bits of the fraction
  unsigned bin_shift_ = 31;
};

}  // namespace gibench
