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
  explicit Coefficients(const Hierarchy& hierarchy) : hierarchy_(&hierarchy), slot_(hierarchy.size(), none) {}

  bool has(std::uint32_t point) const { return slot_[point] != none; }
  /// Zero for a basis function that has not been computed.
  Rgb operator[](std::uint32_t point) const { return has(point) ? values_[slot_[point]] : Rgb(); }
  void set(std::uint32_t point, const Rgb& value);
  void add(std::uint32_t point, const Rgb& value) { set(point, (*this)[point] + value); }

  /// The computed basis functions in the order of their numbers, hence coarse to fine.
  std::vector<std::uint32_t> sorted_points() const;
  std::size_t size() const { return points_.size(); }
  const Hierarchy& hierarchy() const { return *hierarchy_; }

  /// F_i of Eq. 7 at a place: the sum over levels 0 … last_level. A level of which no basis function covers the
  /// place contributes nothing.
  Rgb evaluate(const Place& at, std::uint32_t last_level) const;

  std::size_t bytes() const {
    return slot_.capacity() * sizeof(std::uint32_t) + points_.capacity() * sizeof(std::uint32_t) +
           values_.capacity() * sizeof(Rgb);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  const Hierarchy* hierarchy_;
  std::vector<std::uint32_t> slot_;  ///< of every point of the hierarchy
  std::vector<std::uint32_t> points_;
  std::vector<Rgb> values_;
};

}  // namespace gibench::meshless
