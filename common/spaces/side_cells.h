/// Cells of triangle sides: large sides are cut into alike smaller triangles, so that light on a part of them is known apart.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/core/vec.h"
#include "common/ray/world.h"

namespace gibench {

/// Which sides have cells.
enum class CellSides {
  lit,  ///< the fronts, and the backs of two-sided objects
  all   ///< the black backs as well
};

/// The cells of all sides, numbered; those of a side follow one another. Triangles without area, and those hidden by a twin, have
/// none. A side has n² cells, n growing with the root of its area.
class SideCells {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// About `cells_by_area` cells are shared out by area; each side has one at least.
  SideCells(const World& world, CellSides sides, std::size_t cells_by_area);

  std::size_t size() const { return side_.size(); }
  /// The number of a side among all: the fronts of the triangles are the even ones.
  static std::uint32_t side_number(std::uint32_t triangle, bool front) { return 2 * triangle + (front ? 0U : 1U); }
  std::uint32_t begin(std::uint32_t side) const { return begin_[side]; }
  std::uint32_t end(std::uint32_t side) const { return begin_[side + 1]; }

  std::uint32_t triangle(std::uint32_t cell) const { return side_[cell] / 2; }
  bool front(std::uint32_t cell) const { return side_[cell] % 2 == 0; }
  float area(std::uint32_t cell) const;  ///< m²

  /// The cell at a place of a side; none where the side has no cells.
  std::uint32_t at(std::uint32_t triangle, bool front, Vec2 barycentrics) const {
    const std::uint32_t side = side_number(triangle, front);
    const std::uint32_t first = begin_[side], count = begin_[side + 1] - first;
    return count <= 1 ? (count == 0 ? none : first) : first + local_at(rows_[triangle], barycentrics);
  }
  /// Barycentrics of the point of a cell that lies at `place` in a triangle.
  Vec2 barycentrics(std::uint32_t cell, Vec2 place) const;

  /// The inverse: where in its cell a point of a triangle lies.
  Vec2 place_in(std::uint32_t cell, Vec2 barycentrics) const;

  std::size_t bytes() const;

 private:
  struct Position {
    std::uint32_t row, column;
    bool turned;
  };
  Position position(std::uint32_t cell) const;

  /// Row by row along the second corner's barycentric; a row of k cells' length has 2k − 1 of them, upright ones and turned ones
  /// by turns.
  static std::uint32_t local_at(std::uint32_t rows, Vec2 barycentrics) {
    const auto n = static_cast<float>(rows);
    const float x = std::clamp(barycentrics.x * n, 0.0F, n), y = std::clamp(barycentrics.y * n, 0.0F, n);
    const std::uint32_t row = std::min(static_cast<std::uint32_t>(x), rows - 1);
    const std::uint32_t length = rows - row;
    const std::uint32_t column = std::min(static_cast<std::uint32_t>(y), length - 1);
    const bool turned = column + 1 < length && (x - static_cast<float>(row)) + (y - static_cast<float>(column)) > 1.0F;
    return row * (2 * rows - row) + 2 * column + (turned ? 1U : 0U);
  }

  const World& world_;
  std::vector<std::uint16_t> rows_;   ///< n of every triangle
  std::vector<std::uint32_t> begin_;  ///< first cell of every side; one more than sides
  std::vector<std::uint32_t> side_;   ///< of every cell
};

}  // namespace gibench
