#include "common/geometry/convexity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry/mesh_topology.h"

namespace gibench {

namespace {

constexpr std::size_t most_pairs = 100'000'000;
constexpr int extreme_directions = 128;

struct Plane {
  Vec3 normal;   // unit
  Vec3 through;  // a corner of the triangle
  float height(const Vec3& point) const { return glm::dot(normal, point - through); }
};

/// The plane of a triangle; a zero normal for a degenerate one.
Plane plane_of(std::span<const Vec3> vertices, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  const Vec3d doubled = glm::cross(Vec3d(vertices[b]) - Vec3d(vertices[a]), Vec3d(vertices[c]) - Vec3d(vertices[a]));
  const double length = glm::length(doubled);
  return {length > 0.0 ? Vec3(doubled / length) : Vec3(0.0F), vertices[a]};
}

/// What has been seen in front of and behind the planes so far.
class Sides {
 public:
  explicit Sides(float tolerance) : tolerance_(tolerance) {}
  void see(float height) {
    front_ = front_ || height > tolerance_;
    back_ = back_ || height < -tolerance_;
  }
  bool both() const { return front_ && back_; }

 private:
  float tolerance_;
  bool front_ = false, back_ = false;
};

/// The vertices that lie farthest in directions spread evenly over the sphere (a Fibonacci lattice).
std::vector<std::uint32_t> extreme_vertices(std::span<const Vec3> vertices, const std::vector<std::uint32_t>& used) {
  std::vector<std::uint32_t> extremes;
  constexpr double golden_angle = 2.399963229728653;  // pi (3 - sqrt 5)
  for (int i = 0; i < extreme_directions; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / extreme_directions;
    const double radius = std::sqrt(1.0 - z * z);
    const Vec3 direction(radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i), z);
    extremes.push_back(*std::max_element(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) {
      return glm::dot(direction, vertices[a]) < glm::dot(direction, vertices[b]);
    }));
  }
  std::sort(extremes.begin(), extremes.end());
  extremes.erase(std::unique(extremes.begin(), extremes.end()), extremes.end());
  return extremes;
}

/// Welded corners of all triangles, each once.
std::vector<std::uint32_t> used_vertices(std::span<const Triangle> triangles, std::span<const std::uint32_t> weld) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t corner : triangle.corners) used.push_back(weld[corner]);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Looks at the corners of each triangle from its neighbours across edges; dents show here at once.
void see_neighbours(std::span<const Vec3> vertices, std::span<const Triangle> triangles, std::span<const std::uint32_t> weld,
                    const std::vector<Plane>& planes, Sides& sides) {
  std::vector<Face> faces;
  faces.reserve(triangles.size());
  for (const Triangle& t : triangles) faces.push_back({{t.corners[0], t.corners[1], t.corners[2], t.corners[2]}});
  for (const FacePair& pair : neighbouring_faces(faces, weld)) {
    for (const std::uint32_t corner : triangles[pair.second].corners) sides.see(planes[pair.first].height(vertices[corner]));
    for (const std::uint32_t corner : triangles[pair.first].corners) sides.see(planes[pair.second].height(vertices[corner]));
    if (sides.both()) return;
  }
}

}  // namespace

bool bounds_convex_set(std::span<const Vec3> vertices, std::span<const Triangle> triangles, std::span<const std::uint32_t> weld,
                       float tolerance) {
  std::vector<Plane> planes;
  planes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) planes.push_back(plane_of(vertices, triangle));
  const auto is_plane = [](const Plane& plane) { return plane.normal != Vec3(0.0F); };
  if (std::none_of(planes.begin(), planes.end(), is_plane)) return false;

  Sides sides(tolerance);
  see_neighbours(vertices, triangles, weld, planes, sides);
  if (sides.both()) return false;
  std::vector<std::uint32_t> looked_at = used_vertices(triangles, weld);
  if (looked_at.size() * planes.size() > most_pairs) looked_at = extreme_vertices(vertices, looked_at);
  for (const Plane& plane : planes) {
    for (const std::uint32_t vertex : looked_at) sides.see(plane.height(vertices[vertex]));
    if (sides.both()) return false;
  }
  return true;
}

}  // namespace gibench
