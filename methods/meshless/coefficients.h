/// A function in the basis: coefficients of those basis functions that have been computed; all others are zero
/// (Lehtinen et al. 2007, Eq. 9 and 10).
#pragma once

#include <cstdint>
#include <vector>

#include "common/core/rgb.h"
#include "methods/meshless/hierarchy.h"

namespace gibench::meshless {

class Coefficients {
 public:
  /// `channels`: 3, or 1 where all channels of every value are equal and one is kept for them.
  explicit Coefficients(const Hierarchy& hierarchy, int channels = 3)
      : hierarchy_(&hierarchy), channels_(static_cast<std::uint32_t>(channels)), slot_(hierarchy.size(), none) {}

  bool has(std::uint32_t point) const { return slot_[point] != none; }
  /// Zero for a basis function that has not been computed.
  Rgb operator[](std::uint32_t point) const { return has(point) ? value_in(slot_[point]) : Rgb(); }
  void set(std::uint32_t point, const Rgb& value);
  void add(std::uint32_t point, const Rgb& value) { set(point, (*this)[point] + value); }

  /// The computed basis functions in the order of their numbers, hence coarse to fine.
  std::vector<std::uint32_t> sorted_points() const;
  std::size_t size() const { return points_.size(); }
  const Hierarchy& hierarchy() const { return *hierarchy_; }
  int channels() const { return static_cast<int>(channels_); }

  /// F_i of Eq. 7 at a place: the sum over levels 0 … last_level. A level of which no basis function covers the
  /// place contributes nothing.
  Rgb evaluate(const Place& at, std::uint32_t last_level) const;

  std::size_t bytes() const {
    return slot_.capacity() * sizeof(std::uint32_t) + points_.capacity() * sizeof(std::uint32_t) +
           values_.capacity() * sizeof(float);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  Rgb value_in(std::uint32_t slot) const {
    if (channels_ == 1) return Rgb(values_[slot]);
    const float* value = &values_[std::size_t{3} * slot];
    return {value[0], value[1], value[2]};
  }
  const Hierarchy* hierarchy_;
  std::uint32_t channels_;
  std::vector<std::uint32_t> slot_;  ///< of every point of the hierarchy
  std::vector<std::uint32_t> points_;
  std::vector<float> values_;  ///< channels_ of every slot
};

}  // namespace gibench::meshless
