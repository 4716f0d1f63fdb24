#include "common/geometry/crease_vertices.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cmath>
#include <numeric>

#include "common/core/error.h"

namespace gibench {

namespace {

using HalfEdges = OpenMesh::PolyMesh_ArrayKernelT<>;
using VertexHandle = OpenMesh::VertexHandle;

std::size_t corner_count(const Face& face) { return face.is_quad() ? 4 : 3; }

/// The faces as half-edges, in their order.
class FaceFans {
 public:
  FaceFans(std::size_t points, std::span<const Face> faces) : points_of_vertex_(points) {
    mesh_.reserve(points, 2 * faces.size(), faces.size());
    for (std::size_t i = 0; i < points; ++i) mesh_.add_vertex({});
    std::iota(points_of_vertex_.begin(), points_of_vertex_.end(), 0U);
    ::omerr().disable();  // a refused face is not an error here
    for (const Face& face : faces) add(face);
    ::omerr().enable();
  }

  const HalfEdges& mesh() const { return mesh_; }
  std::uint32_t point(VertexHandle vertex) const { return points_of_vertex_[static_cast<std::size_t>(vertex.idx())]; }
  std::size_t refused() const { return refused_; }

 private:
  void add(const Face& face) {
    std::vector<VertexHandle> corners;
    for (std::size_t i = 0; i < corner_count(face); ++i) corners.emplace_back(static_cast<int>(face.corners[i]));
    if (mesh_.add_face(corners).is_valid()) return;
    ++refused_;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = mesh_.add_vertex({});
      points_of_vertex_.push_back(face.corners[i]);
    }
    GIBENCH_CHECK(mesh_.add_face(corners).is_valid(), "a face by itself is always taken");
  }

  HalfEdges mesh_;
  std::vector<std::uint32_t> points_of_vertex_;
  std::size_t refused_ = 0;
};

/// Corners joined into vertices. The corner of a face at a vertex is named by the face's half-edge that ends there.
class Corners {
 public:
  explicit Corners(const HalfEdges& mesh) : parent_(mesh.n_halfedges()) { std::iota(parent_.begin(), parent_.end(), 0); }
  void join(OpenMesh::HalfedgeHandle a, OpenMesh::HalfedgeHandle b) { parent_[index(root(a.idx()))] = root(b.idx()); }
  std::size_t vertex(OpenMesh::HalfedgeHandle h) { return index(root(h.idx())); }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int root(int i) {
    while (parent_[index(i)] != i) i = parent_[index(i)] = parent_[index(parent_[index(i)])];
    return i;
  }
  std::vector<int> parent_;
};

void join_across_smooth_edges(const HalfEdges& mesh, std::span<const Vec3> normals, float crease_degrees, Corners& corners) {
  const float least_cosine = std::cos(crease_degrees * pi / 180.0F);
  for (const auto edge : mesh.edges()) {
    const auto one = edge.h0(), other = edge.h1();
    if (one.is_boundary() || other.is_boundary()) continue;
    const auto face = static_cast<std::size_t>(one.face().idx()), neighbour = static_cast<std::size_t>(other.face().idx());
    // Not below the bound by rounding: flat is smooth whatever the bound.
    if (glm::dot(normals[face], normals[neighbour]) < least_cosine - 1e-6F) continue;
    corners.join(one, other.prev());
    corners.join(other, one.prev());
  }
}

}  // namespace

CreaseVertices crease_vertices(std::size_t points, std::span<const Face> faces, std::span<const Vec3> normals,
                               float crease_degrees) {
  const FaceFans fans(points, faces);
  Corners corners(fans.mesh());
  join_across_smooth_edges(fans.mesh(), normals, crease_degrees, corners);
  CreaseVertices result;
  result.refused_faces = fans.refused();
  constexpr std::uint32_t unset = 0xffffffffU;
  std::vector<std::uint32_t> numbers(fans.mesh().n_halfedges(), unset);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    auto& of_face = result.of_face.emplace_back();
    for (const auto half_edge : fans.mesh().fh_range(OpenMesh::FaceHandle(static_cast<int>(f)))) {
      const std::uint32_t point = fans.point(half_edge.to());
      std::uint32_t& number = numbers[corners.vertex(half_edge)];
      if (number == unset) {
        number = static_cast<std::uint32_t>(result.point.size());
        result.point.push_back(point);
      }
      for (std::size_t i = 0; i < 4; ++i)
        if (faces[f].corners[i] == point) of_face[i] = number;
    }
  }
  return result;
}

}  // namespace gibench
