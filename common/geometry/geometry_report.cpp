#include "common/geometry/geometry_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "common/geometry/convexity.h"
#include "common/geometry/mesh_topology.h"

namespace gibench {

namespace {

// Faces are plane and vertices at their places up to this share of the bounding box's diagonal.
constexpr float planarity = 1e-5F;

/// A run of faces and their triangles.
struct Part {
  std::span<const Face> faces;
  std::span<const Triangle> triangles;
};

/// Twice the vector area of a triangle, m².
Vec3d doubled_area(const Scene& scene, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return glm::cross(Vec3d(scene.vertices[b]) - Vec3d(scene.vertices[a]), Vec3d(scene.vertices[c]) - Vec3d(scene.vertices[a]));
}

bool has_equal_corners(const Scene& scene, const Face& face) {
  const std::size_t count = face.is_quad() ? 4 : 3;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (scene.vertices[face.corners[i]] == scene.vertices[face.corners[j]]) return true;
  return false;
}

bool is_degenerate(const Scene& scene, const Face& face) {
  if (has_equal_corners(scene, face)) return true;
  const auto& [a, b, c, d] = face.corners;
  double area = glm::length(doubled_area(scene, {{a, b, c}}));
  if (face.is_quad()) area += glm::length(doubled_area(scene, {{a, c, d}}));
  return area == 0.0;
}

void count_faces(const Scene& scene, const Part& part, GeometryReport& report) {
  report.faces = part.faces.size();
  for (const Face& face : part.faces) {
    (face.is_quad() ? report.quads : report.triangles) += 1;
    if (is_degenerate(scene, face)) ++report.degenerate_faces;
  }
}

/// Vertices of an object that lie exactly where an earlier one of it does.
std::size_t count_duplicates(const Scene& scene, const Object& object) {
  const auto vertices = std::span(scene.vertices).subspan(object.vertex_begin, object.vertex_end - object.vertex_begin);
  const std::vector<std::uint32_t> weld = weld_vertices(vertices, 0.0F);
  std::size_t duplicates = 0;
  for (std::uint32_t i = 0; i < weld.size(); ++i)
    if (weld[i] != i) ++duplicates;
  return duplicates;
}

void measure(const Scene& scene, const Part& part, GeometryReport& report) {
  if (part.faces.empty()) return;
  Vec3 low = scene.vertices[part.faces.front().corners[0]], high = low;
  for (const Face& face : part.faces)
    for (const std::uint32_t corner : face.corners) {
      low = glm::min(low, scene.vertices[corner]);
      high = glm::max(high, scene.vertices[corner]);
    }
  report.bounds_min = Vec3d(low) + scene.origin;
  report.bounds_max = Vec3d(high) + scene.origin;
  double doubled = 0.0, six_volumes = 0.0;
  for (const Triangle& triangle : part.triangles) {
    const Vec3d area = doubled_area(scene, triangle);
    doubled += glm::length(area);
    six_volumes += glm::dot(Vec3d(scene.vertices[triangle.corners[0]]) - Vec3d(low), area);
  }
  report.area = 0.5 * doubled;
  if (report.closed && report.oriented) report.volume = six_volumes / 6.0;
}

/// `weld` covers all vertices of the scene.
GeometryReport report_part(const Scene& scene, const Part& part, std::span<const std::uint32_t> weld) {
  GeometryReport report;
  count_faces(scene, part, report);
  const MeshTopology topology = mesh_topology(part.faces, weld);
  report.non_manifold_edges = topology.non_manifold_edges;
  report.boundary_edges = topology.boundary_edges;
  report.flipped_edges = topology.flipped_edges;
  report.components = topology.components;
  report.closed = topology.closed;
  report.oriented = topology.oriented();
  measure(scene, part, report);
  const auto diagonal = static_cast<float>(glm::length(report.bounds_max - report.bounds_min));
  report.convex = report.closed && report.components == 1 && report.oriented &&
                  bounds_convex_set(scene.vertices, part.triangles, weld, planarity * diagonal);
  return report;
}

}  // namespace

GeometryReport report_geometry(const Scene& scene) {
  const std::vector<std::uint32_t> weld = weld_vertices(scene.vertices, weld_tolerance(scene.vertices));
  GeometryReport report = report_part(scene, {scene.faces, scene.triangles}, weld);
  report.name = scene.name;
  report.vertices = scene.vertices.size();
  for (const Object& object : scene.objects) report.duplicate_vertices += count_duplicates(scene, object);
  return report;
}

std::vector<GeometryReport> report_objects(const Scene& scene) {
  const std::vector<std::uint32_t> weld = weld_vertices(scene.vertices, weld_tolerance(scene.vertices));
  std::vector<GeometryReport> reports;
  for (const Object& object : scene.objects) {
    const Part part{std::span(scene.faces).subspan(object.face_begin, object.face_end - object.face_begin),
                    std::span(scene.triangles).subspan(object.triangle_begin, object.triangle_end - object.triangle_begin)};
    reports.push_back(report_part(scene, part, weld));
    reports.back().name = object.name;
    reports.back().vertices = object.vertex_end - object.vertex_begin;
    reports.back().duplicate_vertices = count_duplicates(scene, object);
  }
  return reports;
}

nlohmann::ordered_json to_json(const GeometryReport& report) {
  // Positions are kept in single precision: no more digits than that.
  const double diagonal = glm::length(report.bounds_max - report.bounds_min);
  const double digits = diagonal > 0.0 ? std::pow(10.0, std::floor(7.0 - std::log10(diagonal))) : 1.0;
  const auto rounded = [&](double x) { return std::round(x * digits) / digits; };
  const auto list = [&](const Vec3d& v) { return std::vector<double>{rounded(v.x), rounded(v.y), rounded(v.z)}; };
  nlohmann::ordered_json json{{"faces", report.faces},
                              {"triangles", report.triangles},
                              {"quads", report.quads},
                              {"degenerate_faces", report.degenerate_faces},
                              {"vertices", report.vertices},
                              {"duplicate_vertices", report.duplicate_vertices},
                              {"non_manifold_edges", report.non_manifold_edges},
                              {"boundary_edges", report.boundary_edges},
                              {"flipped_edges", report.flipped_edges},
                              {"components", report.components},
                              {"closed", report.closed},
                              {"oriented", report.oriented},
                              {"convex", report.convex},
                              {"bounds_min", list(report.bounds_min)},
                              {"bounds_max", list(report.bounds_max)},
                              {"area", report.area}};
  if (report.closed && report.oriented) json["volume"] = report.volume;
  return json;
}

GeometryReport geometry_report_of(const nlohmann::ordered_json& json) {
  GeometryReport report;
  const auto read = [&json](const char* name, auto& value) {
    if (const auto found = json.find(name); found != json.end()) found->get_to(value);
  };
  const auto read_point = [&json](const char* name, Vec3d& point) {
    if (const auto found = json.find(name); found != json.end())
      for (int i = 0; i < 3; ++i) point[i] = found->at(static_cast<std::size_t>(i)).get<double>();
  };
  read("faces", report.faces);
  read("triangles", report.triangles);
  read("quads", report.quads);
  read("degenerate_faces", report.degenerate_faces);
  read("vertices", report.vertices);
  read("duplicate_vertices", report.duplicate_vertices);
  read("non_manifold_edges", report.non_manifold_edges);
  read("boundary_edges", report.boundary_edges);
  read("flipped_edges", report.flipped_edges);
  read("components", report.components);
  read("closed", report.closed);
  read("oriented", report.oriented);
  read("convex", report.convex);
  read_point("bounds_min", report.bounds_min);
  read_point("bounds_max", report.bounds_max);
  read("area", report.area);
  read("volume", report.volume);
  return report;
}

}  // namespace gibench
