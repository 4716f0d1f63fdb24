/// Straight light on the points of cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/lighting/direct_light.h"
#include "common/spaces/cell_points.h"

namespace gibench {

inline float mean_of_channels(const Rgb& value) { return (value.r + value.g + value.b) / 3.0F; }

/// Cells [begin, end).
struct CellRange {
  std::size_t begin, end;
};

/// By one sample for each point. Where only some points of a cell are lit, more are looked at and all of them get the mean, so
/// that one that lies in a sliver of light does not stand for a quarter of the cell; a sliver in which one point of twenty lies,
/// of a light that has no size and so casts it through a crack, is left out. Immutable, for all threads.
class StraightLight {
 public:
  /// The lights are those of the world's scene.
  StraightLight(const World& world, const CellPoints& points, std::uint64_t seed);

  /// Writes the irradiance of the cells' points, W/m², mean of the channels, to their places in `of_points`.
  void find(const CellRange& cells, std::span<float> of_points, RayStream& rays) const;

 private:
  void find_of(const DirectLight& light, bool from_points, const CellRange& cells, std::span<float> of_points,
               RayStream& rays) const;
  void even_out(const DirectLight& light, bool from_points, std::uint32_t cell, std::span<float> values, RayStream& rays) const;

  const CellPoints& points_;
  std::uint64_t seed_;
  DirectLight punctual_, extended_;  ///< lights without a size, and the others
};

}  // namespace gibench
