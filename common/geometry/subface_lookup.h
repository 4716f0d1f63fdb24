/// Which smaller triangle of a subdivided one holds a point, and where in it.
#pragma once

#include <cstdint>
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

struct SubfacePoint {
  std::uint32_t triangle;
  float second, third;  ///< barycentrics of the smaller triangle's second and third corner, in [0, 1]
};

/// For every outer triangle a raster of its barycentrics, whose cells hold the smaller triangles that may reach into them.
class SubfaceLookup {
 public:
  /// Adds the next outer triangle, covered by these without gaps; none for a degenerate one.
  void add(std::span<const Subface> subfaces);

  bool covers(std::uint32_t outer) const { return rasters_[outer].width > 0; }
  /// The smaller triangle at a point of an outer one that is covered; the nearest where rounding leaves none.
  SubfacePoint find(std::uint32_t outer, Vec2 barycentrics) const;

  std::size_t bytes() const;

 private:
  struct Raster {
    std::uint32_t width = 0;       ///< cells along either barycentric; 0: not covered
    std::uint32_t first_cell = 0;  ///< in cell_begin_; of a raster of one triangle its entry
  };
  /// (second, third) = matrix · (barycentrics − corner)
  struct Entry {
    Vec2 corner;
    float matrix[4];
    std::uint32_t triangle;
  };

  std::uint32_t add_entry(const Subface& subface);

  std::vector<Raster> rasters_;
  std::vector<std::uint32_t> cell_begin_;  ///< into cell_entries_; one more than cells for every raster
  std::vector<std::uint32_t> cell_entries_;
  std::vector<Entry> entries_;
};

}  // namespace gibench
