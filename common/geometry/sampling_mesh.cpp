#include "common/geometry/sampling_mesh.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/geometry/crease_vertices.h"
#include "common/geometry/face_subdivision.h"
#include "common/geometry/mesh_topology.h"

namespace gibench {

namespace {

constexpr float inset = 1.0F / 64.0F;       // of a face: how far a site lies inside it
constexpr float same_plane = 1.0F - 1e-5F;  // cosine between normals of faces that share a site

double area_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return 0.5 * glm::length(glm::cross(b - a, c - a)); }

/// Barycentrics of the second and third corner of a scene triangle, of a point in its plane.
struct Barycentrics {
  Vec3d origin, dual_u, dual_v;

  Barycentrics(const World& world, std::uint32_t triangle) {
    const auto& [a, b, c] = world.scene().triangles[triangle].corners;
    origin = Vec3d(world.scene().vertices[a]);
    const Vec3d u = Vec3d(world.scene().vertices[b]) - origin, v = Vec3d(world.scene().vertices[c]) - origin;
    const Vec3d normal = glm::cross(u, v);
    const double squared = glm::dot(normal, normal);
    dual_u = glm::cross(v, normal) / squared;
    dual_v = glm::cross(normal, u) / squared;
  }
  glm::dvec2 of(const Vec3d& point) const { return {glm::dot(point - origin, dual_u), glm::dot(point - origin, dual_v)}; }
};

/// One triangle or two.
struct Halves {
  std::array<std::array<std::uint32_t, 3>, 2> triangles;
  std::size_t count;
  const auto* begin() const { return triangles.data(); }
  const auto* end() const { return triangles.data() + count; }
  const auto& operator[](std::size_t i) const { return triangles[i]; }
};

/// The triangles of a face; quads of a grid are halved along alternating diagonals.
Halves halves(const Face& face, bool other_diagonal) {
  const auto& [a, b, c, d] = face.corners;
  if (!face.is_quad()) return {{{{a, b, c}}}, 1};
  if (other_diagonal) return {{{{a, b, d}, {b, c, d}}}, 2};
  return {{{{a, b, c}, {a, c, d}}}, 2};
}

/// Numbers of items by group: those of group g are items[begin[g]] … items[begin[g + 1] − 1], ascending.
template <class GroupsOf>
void group(std::size_t groups, std::size_t items, const GroupsOf& each_group_of, std::vector<std::uint32_t>& begin,
           std::vector<std::uint32_t>& grouped) {
  begin.assign(groups + 1, 0);
  for (std::uint32_t i = 0; i < items; ++i) each_group_of(i, [&](std::uint32_t g) { ++begin[g + 1]; });
  for (std::size_t g = 0; g < groups; ++g) begin[g + 1] += begin[g];
  grouped.resize(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < items; ++i) each_group_of(i, [&](std::uint32_t g) { grouped[next[g]++] = i; });
}

}  // namespace

class SamplingMesh::Maker {
 public:
  Maker(SamplingMesh& mesh, const World& world, const SamplingMeshOptions& options)
      : mesh_(mesh), world_(world), options_(options) {}

  void make() {
    const Scene& scene = world_.scene();
    const float weld = weld_tolerance(scene.vertices);
    mesh_.back_offset_.assign(scene.triangles.size(), 0);
    for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
      subdivided_ = subdivide_object(world_, object, options_.edge_length, weld);
      if (!options_.keep_quads) halve_quads();
      add_object(object);
    }
    add_subfaces(scene.triangles.size());
  }

 private:
  void add_subfaces(std::size_t scene_triangles) {
    std::vector<std::uint32_t> begin, order;
    group(
        scene_triangles, subfaces_.size(), [&](std::uint32_t i, const auto& to) { to(covered_[i]); }, begin, order);
    std::vector<Subface> covering;
    for (std::size_t t = 0; t < scene_triangles; ++t) {
      covering.clear();
      for (std::uint32_t i = begin[t]; i < begin[t + 1]; ++i) covering.push_back(subfaces_[order[i]]);
      mesh_.lookup_.add(covering);
    }
  }

  void halve_quads() {
    if (std::none_of(subdivided_.faces.begin(), subdivided_.faces.end(), [](const Face& face) { return face.is_quad(); })) return;
    SubdividedObject halved;
    halved.points = std::move(subdivided_.points);
    for (std::size_t f = 0; f < subdivided_.faces.size(); ++f)
      for (const auto& [a, b, c] : halves(subdivided_.faces[f], f % 2 == 1)) {
        halved.faces.push_back({{a, b, c, c}});
        halved.first_triangle.push_back(subdivided_.first_triangle[f]);
        halved.triangle_count.push_back(subdivided_.triangle_count[f]);
      }
    subdivided_ = std::move(halved);
  }

  void add_object(std::uint32_t object) {
    std::vector<Vec3> normals;
    for (const std::uint32_t t : subdivided_.first_triangle) normals.push_back(world_.normal(t));
    const CreaseVertices made = crease_vertices(subdivided_.points.size(), subdivided_.faces, normals, options_.crease_degrees);
    mesh_.refused_faces_ += made.refused_faces;
    const auto first_triangle = static_cast<std::uint32_t>(mesh_.triangles_.size());
    add_sheet(object, made, true);
    const auto triangles = static_cast<std::uint32_t>(mesh_.triangles_.size()) - first_triangle;
    const Object& source = world_.scene().objects[object];
    if (!source.two_sided) return;
    add_sheet(object, made, false);
    std::fill(mesh_.back_offset_.begin() + source.triangle_begin, mesh_.back_offset_.begin() + source.triangle_end, triangles);
  }

  /// One side of an object.
  void add_sheet(std::uint32_t object, const CreaseVertices& made, bool front) {
    const auto base = static_cast<std::uint32_t>(mesh_.vertices_.size());
    for (const std::uint32_t point : made.point) {
      MeshVertex& vertex = mesh_.vertices_.emplace_back();
      vertex.position = Vec3(subdivided_.points[point]);
      vertex.object = object;
      vertex.front = front;
    }
    areas_.assign(made.point.size(), 0.0);
    normals_.assign(made.point.size(), Vec3d(0.0));
    for (std::size_t f = 0; f < subdivided_.faces.size(); ++f) add_face(f, made.of_face[f], base, front);
    for (std::size_t v = 0; v < areas_.size(); ++v) {
      MeshVertex& vertex = mesh_.vertices_[base + v];
      vertex.area = static_cast<float>(areas_[v]);
      // Faces around a spike may cancel out; what add_face() left is then the normal of one of them.
      const double length = glm::length(normals_[v]);
      if (length > 1e-6 * areas_[v]) vertex.normal = Vec3(normals_[v] / length);
      if (!front) vertex.normal = -vertex.normal;
    }
  }

  void add_face(std::size_t f, const std::array<std::uint32_t, 4>& corners, std::uint32_t base, bool front) {
    const Face& points = subdivided_.faces[f];
    const std::uint32_t scene_triangle = subdivided_.first_triangle[f];
    const Vec3 normal = world_.normal(scene_triangle);
    const Face own{corners};
    const auto& p = subdivided_.points;
    double area = 0.0;
    for (const auto& [a, b, c] : halves(points, false)) area += area_of(p[a], p[b], p[c]);
    const std::size_t corner_count = own.is_quad() ? 4 : 3;
    for (std::size_t i = 0; i < corner_count; ++i) {
      const double share = area / static_cast<double>(corner_count);
      areas_[corners[i]] += share;
      normals_[corners[i]] += share * Vec3d(normal);
      mesh_.vertices_[base + corners[i]].normal = normal;
    }
    const auto face = static_cast<std::uint32_t>(mesh_.faces_.size());
    mesh_.faces_.push_back({{base + corners[0], base + corners[1], base + corners[2], base + corners[3]},
                            scene_triangle,
                            static_cast<float>(area),
                            front});
    const auto of_points = halves(points, f % 2 == 1), of_vertices = halves(own, f % 2 == 1);
    for (std::size_t i = 0; i < of_points.count; ++i) {
      const auto triangle = static_cast<std::uint32_t>(mesh_.triangles_.size());
      const auto& [a, b, c] = of_vertices[i];
      mesh_.triangles_.push_back({{base + a, base + b, base + c}, face});
      if (front) cover(f, of_points[i], triangle);
    }
  }

  /// Notes the triangle under the scene triangles that it lies in.
  void cover(std::size_t f, const std::array<std::uint32_t, 3>& points, std::uint32_t triangle) {
    const std::uint32_t first = subdivided_.first_triangle[f];
    for (std::uint32_t t = first; t < first + subdivided_.triangle_count[f]; ++t) {
      const Barycentrics barycentrics(world_, t);
      Subface subface{};
      for (std::size_t i = 0; i < 3; ++i) subface.corners[i] = Vec2(barycentrics.of(subdivided_.points[points[i]]));
      subface.triangle = triangle;
      subfaces_.push_back(subface);
      covered_.push_back(t);
    }
  }

  SamplingMesh& mesh_;
  const World& world_;
  const SamplingMeshOptions& options_;
  SubdividedObject subdivided_;
  std::vector<double> areas_;   // of the sheet's vertices
  std::vector<Vec3d> normals_;  // times area
  std::vector<Subface> subfaces_;
  std::vector<std::uint32_t> covered_;  // by each subface: the scene triangle
};

/// Where the vertices are looked at from.
class SamplingMesh::SitePlacer {
 public:
  SitePlacer(SamplingMesh& mesh, const World& world, std::span<const std::uint8_t> avoided)
      : mesh_(mesh), world_(world), avoided_(avoided) {}

  void place() {
    mesh_.sites_.clear();
    mesh_.site_begin_.clear();
    std::vector<std::uint32_t> begin, around;
    group(
        mesh_.vertices_.size(), mesh_.triangles_.size(),
        [&](std::uint32_t t, const auto& to) { std::for_each_n(mesh_.triangles_[t].corners.begin(), 3, to); }, begin, around);
    mesh_.site_begin_.push_back(0);
    for (std::uint32_t vertex = 0; vertex < mesh_.vertices_.size(); ++vertex) {
      place_around(vertex, std::span(around).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]));
      mesh_.site_begin_.push_back(static_cast<std::uint32_t>(mesh_.sites_.size()));
    }
  }

 private:
  struct Plane {
    Vec3 normal;
    std::uint32_t largest;
    double largest_area, area;
    bool avoided;
  };

  /// Triangles around a vertex by the plane they lie in: the largest of each takes the site, of those not avoided if any.
  void place_around(std::uint32_t vertex, std::span<const std::uint32_t> around) {
    std::vector<Plane>& planes = planes_;
    planes.clear();
    double total = 0.0;
    for (const std::uint32_t t : around) {
      const Vec3& normal = world_.normal(mesh_.faces_[mesh_.triangles_[t].face].scene_triangle);
      const double area = triangle_area(t);
      const bool avoided = !avoided_.empty() && avoided_[t] != 0;
      total += area;
      const auto same =
          std::find_if(planes.begin(), planes.end(), [&](const Plane& p) { return glm::dot(p.normal, normal) >= same_plane; });
      if (same == planes.end()) {
        planes.push_back({normal, t, area, area, avoided});
        continue;
      }
      same->area += area;
      if (avoided == same->avoided ? area > same->largest_area : same->avoided)
        same->largest = t, same->largest_area = area, same->avoided = avoided;
    }
    for (const Plane& plane : planes) {
      VertexSite site = site_in(plane.largest, vertex);
      site.share = total > 0.0 ? static_cast<float>(plane.area / total) : 1.0F / static_cast<float>(planes.size());
      mesh_.sites_.push_back(site);
    }
  }

  double triangle_area(std::uint32_t t) const {
    const auto& [a, b, c] = mesh_.triangles_[t].corners;
    return area_of(Vec3d(mesh_.vertices_[a].position), Vec3d(mesh_.vertices_[b].position), Vec3d(mesh_.vertices_[c].position));
  }

  VertexSite site_in(std::uint32_t t, std::uint32_t vertex) const {
    Vec3d point(0.0);
    for (const std::uint32_t corner : mesh_.triangles_[t].corners)
      point += Vec3d(mesh_.vertices_[corner].position) * static_cast<double>(corner == vertex ? 1.0F - 2.0F * inset : inset);
    const std::uint32_t first = mesh_.faces_[mesh_.triangles_[t].face].scene_triangle;
    VertexSite best;
    double most_inside = -1e30;
    // A quad of the scene is two triangles in one plane; the point lies in one of them.
    const auto& faces = world_.scene().triangle_face;
    for (std::uint32_t s = first; s < faces.size() && s <= first + 1 && faces[s] == faces[first]; ++s) {
      if (!(world_.area(s) > 0.0F)) continue;
      const glm::dvec2 at = Barycentrics(world_, s).of(point);
      const double inside = std::min({at.x, at.y, 1.0 - at.x - at.y});
      if (inside <= most_inside) continue;
      most_inside = inside;
      best.scene_triangle = s;
      best.barycentrics = Vec2(std::clamp(at.x, 0.0, 1.0), std::clamp(at.y, 0.0, 1.0 - std::clamp(at.x, 0.0, 1.0)));
    }
    return best;
  }

  SamplingMesh& mesh_;
  const World& world_;
  std::span<const std::uint8_t> avoided_;
  std::vector<Plane> planes_;  // around a vertex
};

SamplingMesh::SamplingMesh(const World& world, const SamplingMeshOptions& options) {
  Maker(*this, world, options).make();
  place_sites(world, {});
}

void SamplingMesh::place_sites(const World& world, std::span<const std::uint8_t> avoided) {
  SitePlacer(*this, world, avoided).place();
}

void SamplingMesh::forget_sites() {
  sites_ = {};
  site_begin_ = {};
}

SurfaceSample SamplingMesh::sample(const World& world, std::uint32_t vertex, const VertexSite& site) const {
  const Vec3& front = world.normal(site.scene_triangle);
  return world.sample_at(site.scene_triangle, site.barycentrics, vertices_[vertex].front ? front : -front);
}

std::size_t SamplingMesh::bytes() const {
  return vertices_.size() * sizeof(MeshVertex) + faces_.size() * sizeof(MeshFace) + triangles_.size() * sizeof(MeshTriangle) +
         (back_offset_.size() + site_begin_.size()) * sizeof(std::uint32_t) + sites_.size() * sizeof(VertexSite) +
         lookup_.bytes();
}

double edge_length_for(const World& world, double vertices) { return std::sqrt(world.total_area() / std::max(1.0, vertices)); }

}  // namespace gibench
