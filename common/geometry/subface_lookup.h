/// Lookup of the smaller triangle of a subdivided one that holds a point, and of the place in it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/subface_lattice.h"

namespace gibench {

/// A point of an outer triangle.
struct OuterPoint {
  std::uint32_t outer;
  Vec2 barycentrics;  ///< of its second and third corner
};

/// For every outer triangle the lattice that its smaller ones make, or a raster of its barycentrics, whose cells hold the
/// smaller triangles that may reach into them.
class SubfaceLookup {
 public:
  /// Adds the next outer triangle, covered by these without gaps; none for a degenerate one.
  void add(std::span<const Subface> subfaces);

  bool covers(std::uint32_t outer) const { return rasters_[outer].width > 0; }
  /// The smaller triangle at a point of an outer one that is covered; the nearest where rounding leaves none.
  SubfacePoint find(std::uint32_t outer, Vec2 barycentrics) const {
    const Raster& raster = rasters_[outer];
    if (raster.width == lattice) return lattices_[raster.first_cell].find(barycentrics);
    if (raster.width == 1) return {raster.first_cell, barycentrics.x, barycentrics.y};
    return search(raster, barycentrics);
  }
  /// Starts to fetch what find() will read of these points, which are covered: none of them waits for the memory of another.
  void prefetch(std::span<const OuterPoint> points) const;

  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t lattice = 0xffffffffU;
  struct Raster {
    std::uint32_t width = 0;       ///< cells along either barycentric; 0: not covered; or lattice
    std::uint32_t first_cell = 0;  ///< in cell_begin_; of a raster of one triangle that; of a lattice its number
  };
  /// (second, third) = matrix · (barycentrics − corner)
  struct Entry {
    Vec2 corner;
    float matrix[4];
    std::uint32_t triangle;
  };

  std::uint32_t add_entry(const Subface& subface);
  /// Whether the triangle meets the cell, or nearly.
  static bool reaches(const Entry& entry, std::uint32_t x, std::uint32_t y, std::uint32_t width);

  static std::uint32_t cell_at(const Raster& raster, Vec2 barycentrics);
  SubfacePoint search(const Raster& raster, Vec2 barycentrics) const;

  std::vector<Raster> rasters_;
  std::vector<SubfaceLattice> lattices_;
  std::vector<std::uint32_t> cell_begin_;  ///< into cell_entries_; one more than cells for every raster
  std::vector<std::uint32_t> cell_entries_;
  std::vector<Entry> entries_;
};

}  // namespace gibench
