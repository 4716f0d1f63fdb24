/// Points of the cells of sides: where light is gathered, and which of them stands for a place that a ray meets.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/method/task.h"
#include "common/ray/world.h"
#include "common/spaces/side_cells.h"

namespace gibench {

/// A random point in each of the four parts of each cell (in one where cells are many). A cell is divided where something stands
/// on it between its points or before its corners, as a wall on a ground plane: what is met there is then not the cell as a whole
/// but the point that is not parted from the place, so that no light passes under the wall.
class CellPoints {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Keeps references to world and cells. `points_a_cell`: 1 or 4.
  CellPoints(const World& world, const SideCells& cells, std::uint32_t points_a_cell, Task& task);

  std::uint32_t points_a_cell() const { return points_a_cell_; }
  std::size_t size() const { return places_.size(); }
  std::uint32_t cell(std::uint32_t point) const { return point / points_a_cell_; }
  /// Just as light arrives, on black backs too; nothing where the part of the cell lies behind another surface.
  std::optional<SurfaceSample> sample(std::uint32_t point) const;
  /// Another random point of the cell, by a number; nothing where it lies behind another surface.
  std::optional<SurfaceSample> another(std::uint32_t cell, std::uint64_t number, std::uint64_t seed) const;
  bool is_divided(std::uint32_t cell) const { return divided_[cell] != 0; }

  /// The point that stands for what a ray met; none: nothing, a side without cells, or a place parted from all points of its
  /// cell.
  std::uint32_t met(const Hit& hit, const Vec3& direction, RayStream& rays) const;

 private:
  void place(std::uint32_t point, std::uint64_t seed);
  void find_divided(Task& task);
  bool shows(std::uint32_t cell, Vec2 barycentrics) const;
  bool exists(std::uint32_t point) const { return places_[point].x >= 0.0F; }
  SurfaceSample at(std::uint32_t cell, Vec2 barycentrics) const;
  /// Whether nothing stands between two places of one cell, a little above it.
  bool are_joined(std::uint32_t cell, const SurfaceSample& a, const SurfaceSample& b, RayStream& rays) const;

  const World& world_;
  const SideCells& cells_;
  std::uint32_t points_a_cell_;
  std::vector<Vec2> places_;           ///< barycentrics of every point; negative: it does not exist
  std::vector<std::uint8_t> divided_;  ///< of every cell
};

}  // namespace gibench
