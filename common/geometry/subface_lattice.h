/// Smaller triangles that halve the cells of a lattice: where a point lies is arithmetic, not a search.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/core/vec.h"

namespace gibench {

/// A smaller triangle as seen from the triangle that it covers a part of: corners in the barycentrics (second and
/// third corner) of the latter, which they may lie outside of.
struct Subface {
  Vec2 corners[3];
  std::uint32_t triangle;  ///< what lookups give
};

/// A point by the smaller triangle in which it lies.
struct SubfacePoint {
  std::uint32_t triangle;
  float second, third;  ///< barycentrics of the smaller triangle's second and third corner, in [0, 1]
};

/// A parallelogram cut into a grid, or a triangle cut into n² alike, as a lattice of cells each of which one of its
/// diagonals halves.
class SubfaceLattice {
 public:
  /// Nothing where the triangles are not halves of such cells.
  static std::optional<SubfaceLattice> of(std::span<const Subface> subfaces);

  /// The triangle at a point of the lattice, barycentrics of the outer triangle; the nearest where rounding leaves none.
  SubfacePoint find(Vec2 barycentrics) const {
    const float x = axis_[0].x * barycentrics.x + axis_[0].y * barycentrics.y + offset_.x;
    const float y = axis_[1].x * barycentrics.x + axis_[1].y * barycentrics.y + offset_.y;
    const int column = std::clamp(static_cast<int>(x), 0, columns_ - 1), row = std::clamp(static_cast<int>(y), 0, rows_ - 1);
    const Cell& cell = cells_[static_cast<std::size_t>(row * columns_ + column)];
    const Vec2 at(x - static_cast<float>(column), y - static_cast<float>(row));
    const Half half = cell.half(at);
    const std::uint32_t triangle = cell.triangle(half);
    return triangle != none ? clamped(triangle, corners_[half], at) : nearest({x, y}, column, row);
  }

  std::size_t bytes() const { return sizeof(*this) + cells_.size() * sizeof(Cell); }

 private:
  friend class SubfaceLatticeFit;
  static constexpr std::uint32_t none = 0x7fffffffU, falling_bit = 0x80000000U;

  /// Below and above a diagonal that runs from (0, 0) to (1, 1), or from (1, 0) to (0, 1).
  enum Half : std::uint32_t { below_rising, above_rising, below_falling, above_falling };

  /// The triangles below and above the diagonal; the first's top bit tells a falling one.
  struct Cell {
    std::uint32_t halves[2] = {none, none};

    bool falling() const { return (halves[0] & falling_bit) != 0; }
    Half half(Vec2 at) const {
      const std::uint32_t above = falling() ? (at.x + at.y > 1.0F) : (at.y > at.x);
      return static_cast<Half>((falling() ? below_falling : below_rising) + above);
    }
    std::uint32_t triangle(Half half) const { return halves[half & 1U] & ~falling_bit; }
  };
  /// Barycentrics of a half's second and third corner as affine functions of the place in the cell.
  struct Corners {
    std::array<float, 2> at_zero, along_x, along_y;
    bool operator==(const Corners&) const = default;
  };

  static Vec2 inside(const Corners& corners, Vec2 at) {
    return {corners.at_zero[0] + corners.along_x[0] * at.x + corners.along_y[0] * at.y,
            corners.at_zero[1] + corners.along_x[1] * at.x + corners.along_y[1] * at.y};
  }
  static SubfacePoint clamped(std::uint32_t triangle, const Corners& corners, Vec2 at) {
    const Vec2 inner = inside(corners, at);
    const float second = std::clamp(inner.x, 0.0F, 1.0F);
    return {triangle, second, std::clamp(inner.y, 0.0F, 1.0F - second)};
  }
  /// The triangle nearest to a point of a half that has none, of those of the cells around it.
  SubfacePoint nearest(Vec2 point, int column, int row) const;

  Vec2 axis_[2];  ///< lattice coordinates as affine functions of the outer triangle's barycentrics
  Vec2 offset_{0.0F};
  int columns_ = 0, rows_ = 0;
  std::array<Corners, 4> corners_{};  ///< of every half, those of the rising diagonal first
  std::vector<Cell> cells_;
};

}  // namespace gibench
