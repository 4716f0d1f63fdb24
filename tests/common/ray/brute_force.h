/// The closest hit by trying every triangle in double precision, and a ray backend made of that.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "common/ray/ray_backend.h"

namespace gibench::test {

/// How far the decision was from going the other way is in `margin`.
struct BruteForceHit {
  std::uint32_t triangle = Hit::none;
  double u = 0.0, v = 0.0;
  double distance = INFINITY;
  double margin = INFINITY;  ///< smallest |barycentric coordinate| of a near miss or hit, or gap between two hits
};

/// Möller and Trumbore 1997.
inline BruteForceHit brute_force(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const Ray& ray) {
  BruteForceHit best;
  const Vec3d origin(ray.origin), direction(ray.direction);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& corners = triangles[t].corners;
    const Vec3d a(vertices[corners[0]]);
    const Vec3d first = Vec3d(vertices[corners[1]]) - a, second = Vec3d(vertices[corners[2]]) - a;
    const Vec3d p = glm::cross(direction, second);
    const double determinant = glm::dot(first, p);
    if (determinant == 0.0) continue;
    const Vec3d to_origin = origin - a;
    const double u = glm::dot(to_origin, p) / determinant;
    const Vec3d q = glm::cross(to_origin, first);
    const double v = glm::dot(direction, q) / determinant, distance = glm::dot(second, q) / determinant;
    if (!(distance > ray.t_min && distance < ray.t_max)) continue;
    const double inside = std::min({u, v, 1.0 - u - v});
    if (distance < best.distance || inside < 0.0) best.margin = std::min(best.margin, std::abs(inside));
    if (inside < 0.0) continue;
    if (best.triangle != Hit::none) best.margin = std::min(best.margin, std::abs(distance - best.distance));
    if (distance < best.distance) best.triangle = t, best.u = u, best.v = v, best.distance = distance;
  }
  return best;
}

/// What a backend has to write at least.
class BruteForceBackend final : public RayBackend {
 public:
  BruteForceBackend(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
      : vertices_(vertices.begin(), vertices.end()), triangles_(triangles.begin(), triangles.end()) {}
  std::size_t bytes() const override { return vertices_.size() * sizeof(Vec3) + triangles_.size() * sizeof(Triangle); }

 private:
  void do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const override {
    std::transform(rays.begin(), rays.end(), hits.begin(), [&](const Ray& ray) {
      const BruteForceHit hit = brute_force(vertices_, triangles_, ray);
      if (hit.triangle == Hit::none) return Hit{};
      return Hit{hit.triangle, static_cast<float>(hit.u), static_cast<float>(hit.v), static_cast<float>(hit.distance)};
    });
  }
  void do_occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    std::transform(rays.begin(), rays.end(), occluded.begin(), [&](const Ray& ray) -> std::uint8_t {
      return brute_force(vertices_, triangles_, ray).triangle != Hit::none ? 1 : 0;
    });
  }

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
};

inline std::unique_ptr<const RayBackend> make_brute_force_backend(std::span<const Vec3> vertices,
                                                                  std::span<const Triangle> triangles, int) {
  return std::make_unique<BruteForceBackend>(vertices, triangles);
}

}  // namespace gibench::test
