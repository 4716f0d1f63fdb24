/// Disc elements: one for every vertex of the sampling mesh or for several, with the cell of surface that it stands for.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/random.h"
#include "common/geometry/sampling_mesh.h"
#include "common/method/task.h"
#include "methods/antiradiance/cell_point.h"
#include "methods/antiradiance/form_factor.h"
#include "methods/antiradiance/merging.h"

namespace gibench::antiradiance {

inline constexpr std::uint32_t no_element = 0xffffffffU;

/// A corner's part of a face: corner, middle of one edge, middle of the face, middle of the other edge. A third of a triangle's
/// area, a quarter of a parallelogram's.
struct CellPart {
  std::array<Vec3, 4> corners;
  Vec3 normal;                 ///< unit, of the face on the element's side
  std::uint32_t triangle = 0;  ///< of the scene, in whose plane the part lies
};

/// What rays find out about cells.
struct CellTests {
  int backface_rays = 64;     ///< that must all meet black backs for a point to be inside geometry; 0: no ray is traced at all
  bool looks_behind = false;  ///< whether another surface lies behind, nearer than the disc's radius
};

/// Whether a point just off a surface is not inside geometry: of `count` cosine-distributed rays about the unit normal, a
/// rank-1 lattice, one at least does not meet a black back. Between two sheets, too, most meet one.
bool is_exposed(const World& world, const Vec3& origin, const Vec3& normal, int count, RandomStream random, RayStream& rays);

/// The elements in the order of the mesh's vertices, or of the merging; those that are wholly hidden take no part in transport.
class Elements {
 public:
  /// `points` per cell. A point is not exposed where a coplanar face is in front of it, inside geometry, and where another
  /// surface parts it from the vertex (of an element of one vertex: merging sees to the others).
  Elements(const World& world, const SamplingMesh& mesh, int points, const CellTests& tests, Task& task, Merging merging = {});

  std::size_t size() const { return discs_.size(); }
  /// Of a vertex of the mesh.
  std::uint32_t of_vertex(std::uint32_t vertex) const { return merging_.merges() ? merging_.of_vertex[vertex] : vertex; }
  const Merging& merging() const { return merging_; }
  /// Where light gets to; known only where elements are merged.
  Reached reached(std::uint32_t element) const { return merging_.merges() ? merging_.reached[element] : Reached::front; }
  bool is_sealed(std::uint32_t element) const { return reached(element) == Reached::nowhere; }
  /// Centre: of the exposed part of the cell; normal: the vertex's, or the cell's mean; area: the exposed part's.
  const Disc& disc(std::uint32_t element) const { return discs_[element]; }
  /// Twice the object, and one more on its back: what one tree of the hierarchy is made over.
  std::uint32_t sheet(std::uint32_t element) const { return sheets_[element]; }
  /// Whether a coplanar face is in front of a part of the cell.
  bool covered(std::uint32_t element) const { return (marks_[element] & covered_mark) != 0; }
  /// Whether another surface crosses the cell: what lies beyond it has no element.
  bool parted(std::uint32_t element) const { return (marks_[element] & parted_mark) != 0; }
  /// Whether another surface lies behind the disc, nearer than its radius; known only where it was looked for.
  bool backed(std::uint32_t element) const { return (marks_[element] & backed_mark) != 0; }
  /// Share of the cell that is exposed.
  float exposed_share(std::uint32_t element) const { return exposed_share_[element]; }
  /// Whether light that arrives from behind ends here: on one-sided objects. A two-sided sheet has an element each side.
  bool black_back(std::uint32_t element) const { return black_back_[element] != 0; }

  /// Empty where there are many: then the points stand for the cell.
  std::span<const CellPart> parts(std::uint32_t element) const {
    return std::span(parts_).subspan(part_begin_[element], part_begin_[element + 1] - part_begin_[element]);
  }
  std::span<const CellPoint> points(std::uint32_t element) const {
    return std::span(points_).subspan(element * points_per_element_, points_per_element_);
  }
  /// Metres that surround the disc: no point of the cell is further from its centre.
  float reach(std::uint32_t element) const { return reach_[element]; }

  double area() const { return area_; }  ///< m², of all cells: that of the mesh
  std::size_t bytes() const;

 private:
  void set_out(const World& world, const SamplingMesh& mesh);
  void cut_cells(const World& world, const SamplingMesh& mesh);
  void place_points(const World& world, std::uint32_t element, std::uint64_t seed);
  std::span<CellPoint> own_points(std::uint32_t element) {
    return std::span(points_).subspan(element * points_per_element_, points_per_element_);
  }
  void find_exposed(const World& world, std::uint32_t element, const CellTests& tests, std::uint64_t seed, RayStream& rays);
  void place_disc(std::uint32_t element);
  void let_many_parts_go();

  static constexpr std::uint8_t covered_mark = 1, parted_mark = 2, backed_mark = 4, several_mark = 8;

  std::size_t points_per_element_;
  Merging merging_;
  std::vector<Disc> discs_;  ///< while they are made, of the whole cell, centred on the vertex
  std::vector<std::uint32_t> sheets_;
  std::vector<std::uint8_t> black_back_, marks_;
  std::vector<float> exposed_share_, reach_;
  std::vector<CellPart> parts_;
  std::vector<std::uint32_t> part_begin_;
  std::vector<CellPoint> points_;
  double area_ = 0.0;
};

}  // namespace gibench::antiradiance
