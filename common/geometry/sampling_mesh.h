/// A mesh over the scene whose vertices carry values, and the way from a point of the scene to its vertices.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/subface_lookup.h"
#include "common/ray/world.h"

namespace gibench {

/// How finely the scene is cut, and where normals may break.
struct SamplingMeshOptions {
  double edge_length = std::numeric_limits<double>::infinity();  ///< metres; longer edges are cut; infinity: none
  float crease_degrees = 40.0F;  ///< largest angle between the normals of faces that share a vertex
  bool keep_quads = false;       ///< faces may be quads: those of planar convex quads of the scene
};

/// One side of one place: on a two-sided object every vertex has a twin on the other side.
struct MeshVertex {
  Vec3 position{0.0F};
  Vec3 normal{0.0F};  ///< unit, on the vertex's side; mean of the faces' normals by area
  std::uint32_t object = 0;
  float area = 0.0F;  ///< m²: a third of every triangle and a quarter of every quad that it is a corner of
  bool front = true;  ///< on the front of its faces
};

/// A face of the mesh, on one side of the scene.
struct MeshFace {
  std::array<std::uint32_t, 4>
      corners{};  ///< vertices; counter-clockwise seen from the front, on backs too; a triangle repeats its third
  std::uint32_t scene_triangle = 0;  ///< that it lies in; of a quad the first of two
  float area = 0.0F;                 ///< m²
  bool front = true;
  bool is_quad() const { return corners[3] != corners[2]; }
};

/// What values are interpolated on: every triangular face is one, every quad two.
struct MeshTriangle {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t face = 0;
};

/// A point of the mesh: the weights of a triangle's corners, not negative, with sum 1.
struct MeshPoint {
  std::uint32_t triangle = 0;
  std::array<float, 3> weights{};
};

/// Where a vertex is looked at from: a point just inside a face around it, off the edge where another surface may begin,
/// with that face's normal. Faces in one plane share one.
struct VertexSite {
  std::uint32_t scene_triangle = 0;
  Vec2 barycentrics{0.0F};
  float share = 1.0F;  ///< of the vertex's area
};

/// Made object by object: vertices are welded inside an object and split at its creases, never shared between two. Faces are
/// cut alike on both sides of every shared edge (face_subdivision.h): no cracks. Vertices that no face with area uses do
/// not occur, nor do degenerate faces; points of the latter are not covered. Fronts and backs of a two-sided object are two
/// sheets of the same shape, so that areas add up to that of all lit sides. Non-manifold edges part
/// the faces along them (crease_vertices.h). Keeps no reference to the world.
class SamplingMesh {
 public:
  explicit SamplingMesh(const World& world, const SamplingMeshOptions& options = {});

  std::span<const MeshVertex> vertices() const { return vertices_; }
  std::span<const MeshFace> faces() const { return faces_; }
  std::span<const MeshTriangle> triangles() const { return triangles_; }
  std::size_t refused_faces() const { return refused_faces_; }  ///< parted from their neighbours: not manifold

  /// Whether points of this side of a scene triangle are covered: not on degenerate triangles and black backs.
  bool covers(std::uint32_t scene_triangle, bool front) const {
    return lookup_.covers(scene_triangle) && (front || back_offset_[scene_triangle] != 0);
  }
  /// A point of a scene triangle (barycentrics of its second and third corner) that is covered on that side.
  MeshPoint locate(std::uint32_t scene_triangle, Vec2 barycentrics, bool front) const {
    const SubfacePoint p = lookup_.find(scene_triangle, barycentrics);
    return {front ? p.triangle : p.triangle + back_offset_[scene_triangle], {1.0F - p.second - p.third, p.second, p.third}};
  }

  /// Starts to fetch what locate() will read of points of scene triangles.
  void prefetch(std::span<const OuterPoint> points) const { lookup_.prefetch(points); }

  std::span<const VertexSite> sites(std::uint32_t vertex) const {
    return std::span(sites_).subspan(site_begin_[vertex], site_begin_[vertex + 1] - site_begin_[vertex]);
  }
  /// Places the sites again, in triangles that are not among these (not zero: avoid) where a vertex has others in the same
  /// plane: those that another surface cuts through may lie on its far side there.
  void place_sites(const World& world, std::span<const std::uint8_t> avoided);
  /// Frees the memory of the sites: sites() may not be asked from then on.
  void forget_sites();
  /// A site as a surface sample, on the vertex's side.
  SurfaceSample sample(const World& world, std::uint32_t vertex, const VertexSite& site) const;

  std::size_t bytes() const;

 private:
  class Maker;
  class SitePlacer;

  std::vector<MeshVertex> vertices_;
  std::vector<MeshFace> faces_;
  std::vector<MeshTriangle> triangles_;
  std::vector<std::uint32_t> back_offset_;  ///< of a scene triangle: from a mesh triangle to its twin; 0: no back
  std::vector<VertexSite> sites_;
  std::vector<std::uint32_t> site_begin_;
  SubfaceLookup lookup_;
  std::size_t refused_faces_ = 0;
};

/// The edge length, metres, at which about `vertices` vertices lie on each side of the scene's whole area.
double edge_length_for(const World& world, double vertices);

}  // namespace gibench
