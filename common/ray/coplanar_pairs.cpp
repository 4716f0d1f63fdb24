#include "common/ray/coplanar_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/ray/embree/box_pairs.h"
#include "common/ray/ray_offset.h"

namespace gibench {

namespace {

/// A triangle in double precision.
struct Flat {
  std::array<Vec3d, 3> corners;
  Vec3d normal{0.0};  ///< unit; zero for a degenerate triangle
  double tolerance = 0.0, extent = 0.0;
};

Flat flatten(std::span<const Vec3> vertices, const Triangle& triangle) {
  Flat flat;
  float coordinate = 0.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& corner = vertices[triangle.corners[i]];
    flat.corners[i] = Vec3d(corner);
    coordinate = std::max(coordinate, max_abs(corner));
  }
  const Vec3d first = flat.corners[1] - flat.corners[0], second = flat.corners[2] - flat.corners[0];
  const Vec3d doubled = glm::cross(first, second);
  const double length = glm::length(doubled);
  if (length > 0.0) flat.normal = doubled / length;
  const float extent = std::max(max_abs(Vec3(first)), max_abs(Vec3(second)));
  flat.extent = static_cast<double>(extent);
  flat.tolerance = static_cast<double>(ray_offset(coordinate, extent));
  return flat;
}

/// A convex polygon: two triangles overlap in six corners at most.
struct Polygon {
  std::array<Vec3d, 8> corners;
  std::size_t size = 0;

  void add(const Vec3d& corner) {
    if (size < corners.size()) corners[size++] = corner;
  }
};

/// What lies on the inner side of the plane (Sutherland and Hodgman 1974).
Polygon clip(const Polygon& polygon, const Vec3d& on_plane, const Vec3d& inward) {
  Polygon inside;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec3d& here = polygon.corners[i];
    const Vec3d& next = polygon.corners[(i + 1) % polygon.size];
    const double distance = glm::dot(here - on_plane, inward), next_distance = glm::dot(next - on_plane, inward);
    if (distance >= 0.0) inside.add(here);
    if ((distance < 0.0) != (next_distance < 0.0)) inside.add(here + distance / (distance - next_distance) * (next - here));
  }
  return inside;
}

/// Whether b lies over or under a, no farther than rays can tell apart, on more than a seam.
bool overlap(const Flat& a, const Flat& b) {
  const double tolerance = std::max(a.tolerance, b.tolerance);
  Polygon common;
  for (const Vec3d& corner : b.corners) common.add(corner);
  for (std::size_t i = 0; i < 3 && common.size > 0; ++i) {
    const Vec3d& here = a.corners[i];
    common = clip(common, here, glm::cross(a.normal, a.corners[(i + 1) % 3] - here));
  }
  if (common.size < 3) return false;
  Vec3d doubled_area(0.0);
  double longest = 0.0;
  for (std::size_t i = 0; i < common.size; ++i) {
    const Vec3d from_first = common.corners[i] - common.corners[0];
    if (std::abs(glm::dot(common.corners[i] - a.corners[0], a.normal)) > tolerance) return false;
    longest = std::max(longest, glm::length(from_first));
    if (i + 1 < common.size) doubled_area += glm::cross(from_first, common.corners[i + 1] - common.corners[0]);
  }
  // Neighbours whose shared edge is rounded overlap in a sliver as wide as the rounding.
  return std::abs(glm::dot(doubled_area, a.normal)) > 4.0 * tolerance * longest;
}

bool have_same_corners(const Flat& a, const Flat& b) {
  return std::all_of(a.corners.begin(), a.corners.end(), [&](const Vec3d& corner) {
    return std::find(b.corners.begin(), b.corners.end(), corner) != b.corners.end();
  });
}

Box box_around(std::span<const Vec3> vertices, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return {glm::min(glm::min(vertices[a], vertices[b]), vertices[c]), glm::max(glm::max(vertices[a], vertices[b]), vertices[c])};
}

}  // namespace

std::vector<CoplanarPair> coplanar_pairs(std::span<const Vec3> vertices, std::span<const Triangle> triangles, int threads) {
  std::vector<Flat> flats;
  std::vector<Box> boxes;
  flats.reserve(triangles.size());
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    flats.push_back(flatten(vertices, triangle));
    Box box = box_around(vertices, triangle);
    const Vec3 room(static_cast<float>(flats.back().tolerance));
    boxes.push_back({box.low - room, box.high + room});
  }
  // Planes that nearly agree: steeper ones part by more than the tolerance within any overlap that is more than a seam.
  constexpr double parallel = 1.0 - 1e-4;
  const auto keep = [&](std::uint32_t i, std::uint32_t j) {
    const Flat &a = flats[i], &b = flats[j];
    if (!(std::abs(glm::dot(a.normal, b.normal)) > parallel)) return false;
    return a.extent >= b.extent ? overlap(a, b) : overlap(b, a);
  };
  std::vector<CoplanarPair> pairs;
  for (const auto& [a, b] : overlapping_boxes(boxes, threads, keep))
    pairs.push_back({a, b, glm::dot(flats[a].normal, flats[b].normal) > 0.0, have_same_corners(flats[a], flats[b])});
  return pairs;
}

}  // namespace gibench
