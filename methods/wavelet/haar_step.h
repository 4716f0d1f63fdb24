/// One step of the Haar transform: from four children to their parent and three wavelets, whatever the children's areas.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gibench::wavelet {

inline constexpr std::size_t child_count = 4;
using Four = std::array<float, child_count>;

/// An orthogonal matrix: row 0 takes the children's smooth coefficients to the parent's, rows 1 to 3 to those of its wavelets. A
/// smooth coefficient is the integral over the node times 1/√area. Of children of equal areas the rows are those of the 2D
/// non-standard Haar functions (Kontkanen et al. 2006, figure 2b): along one side, along the other, and along both.
class HaarStep {
 public:
  HaarStep() = default;
  /// The reflection that takes (1, 1, 1, 1)/2 to the unit vector s of roots of shares takes the rows of the equal case to an
  /// orthonormal set that begins with s. Children without area have nothing but zeros in row 0; no area at all: the equal case.
  explicit HaarStep(const std::array<double, child_count>& areas) {
    const double total = areas[0] + areas[1] + areas[2] + areas[3];
    std::array<double, child_count> across{};
    double squared = 0.0;
    for (std::size_t i = 0; i < child_count; ++i) {
      across[i] = 0.5 - (total > 0.0 ? std::sqrt(areas[i] / total) : 0.5);
      squared += across[i] * across[i];
    }
    for (std::size_t row = 0; row < child_count; ++row) {
      double along = 0.0;
      for (std::size_t i = 0; i < child_count; ++i) along += equal[row][i] * across[i];
      for (std::size_t i = 0; i < child_count; ++i)
        rows_[row][i] = static_cast<float>(equal[row][i] - (squared > 1e-14 ? 2.0 * along * across[i] / squared : 0.0));
    }
  }

  const Four& row(std::size_t k) const { return rows_[k]; }

  /// `Value`: anything that is added and multiplied by numbers.
  template <class Value>
  std::array<Value, child_count> up(const std::array<Value, child_count>& children) const {
    std::array<Value, child_count> result{};
    for (std::size_t k = 0; k < child_count; ++k)
      for (std::size_t i = 0; i < child_count; ++i) result[k] += children[i] * rows_[k][i];
    return result;
  }
  template <class Value>
  std::array<Value, child_count> down(const std::array<Value, child_count>& functions) const {
    std::array<Value, child_count> result{};
    for (std::size_t k = 0; k < child_count; ++k)
      for (std::size_t i = 0; i < child_count; ++i) result[i] += functions[k] * rows_[k][i];
    return result;
  }

 private:
  // Children in the order of a quad's corners: the second and the third lie beyond the middle of the first side, the third and
  // the fourth beyond that of the other.
  static constexpr std::array<std::array<double, child_count>, child_count> equal{
      {{0.5, 0.5, 0.5, 0.5}, {0.5, -0.5, -0.5, 0.5}, {0.5, 0.5, -0.5, -0.5}, {0.5, -0.5, 0.5, -0.5}}};
  std::array<Four, child_count> rows_{};
};

}  // namespace gibench::wavelet
