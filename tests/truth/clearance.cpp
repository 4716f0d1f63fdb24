#include "clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace gibench::truth {

namespace {

double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * along);
}

double distance_to_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d normal = glm::cross(b - a, c - a);
  const bool inside = glm::dot(glm::cross(b - a, p - a), normal) >= 0.0 && glm::dot(glm::cross(c - b, p - b), normal) >= 0.0 &&
                      glm::dot(glm::cross(a - c, p - c), normal) >= 0.0;
  if (inside) return std::fabs(glm::dot(p - a, normal)) / glm::length(normal);
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

using Edge = std::array<std::uint32_t, 2>;

/// Edges of the triangles in the plane through `point` that no second of them shares.
std::vector<Edge> open_edges(const Scene& scene, const std::vector<std::uint32_t>& triangles) {
  std::map<Edge, int> uses;
  for (const std::uint32_t t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = scene.triangles[t].corners[i], b = scene.triangles[t].corners[(i + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  std::vector<Edge> edges;
  for (const auto& [edge, count] : uses)
    if (count == 1) edges.push_back(edge);
  return edges;
}

}  // namespace

double clearance_of(const Scene& scene, const Question& question) {
  const Vec3d point = question.point - scene.origin;
  const auto corner = [&](std::uint32_t vertex) { return Vec3d(scene.vertices[vertex]); };
  double nearest = std::numeric_limits<double>::infinity();
  Vec3d low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
  for (const Vec3& vertex : scene.vertices) low = glm::min(low, Vec3d(vertex)), high = glm::max(high, Vec3d(vertex));
  const double on_plane = 1e-5 * glm::length(high - low);
  std::vector<std::uint32_t> own;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const auto& [a, b, c] = scene.triangles[t].corners;
    const Vec3d normal = glm::cross(corner(b) - corner(a), corner(c) - corner(a));
    const double doubled = glm::length(normal);
    if (!(doubled > 0.0)) continue;
    if (std::fabs(glm::dot(point - corner(a), normal)) / doubled < on_plane && glm::dot(normal, question.normal) / doubled > 0.99)
      own.push_back(t);
    else nearest = std::min(nearest, distance_to_triangle(point, corner(a), corner(b), corner(c)));
  }
  for (const Edge& edge : open_edges(scene, own))
    nearest = std::min(nearest, distance_to_segment(point, corner(edge[0]), corner(edge[1])));
  return nearest;
}

bool is_near_edge(const TruthCase& truth, const Question& question) {
  return question.place == Place::point &&
         clearance_of(truth.scene(), question) < near_edge * static_cast<double>(truth.world->diagonal());
}

}  // namespace gibench::truth
