/// A flat quad or triangle, and its parts: what elements and their nodes are in space.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "common/core/vec.h"
#include "methods/wavelet/haar_step.h"

namespace gibench::wavelet {

/// Convex; corners counter-clockwise seen from where the normal points; a triangle repeats its third corner.
struct Patch {
  std::array<Vec3, child_count> corners{};

  bool is_quad() const { return corners[2] != corners[3]; }
  /// m², along the normal.
  Vec3 area_vector() const { return 0.5F * glm::cross(corners[2] - corners[0], corners[3] - corners[1]); }
  float area() const { return is_quad() ? glm::length(area_vector()) : triangle_area(); }
  Vec3 middle() const {
    const Vec3 sum = corners[0] + corners[1] + corners[2];
    return is_quad() ? 0.25F * (sum + corners[3]) : sum / 3.0F;
  }
  std::size_t corner_count() const { return is_quad() ? 4 : 3; }
  /// Metres: no point is further from the middle.
  float radius() const {
    float largest = 0.0F;
    for (const Vec3& corner : corners) largest = std::fmax(largest, glm::length(corner - middle()));
    return largest;
  }

  /// Of a quad the parts of its bilinear map, in the order of the corners; of a triangle three at its corners, then the middle.
  std::array<Patch, child_count> parts() const {
    const auto& [a, b, c, d] = corners;
    const Vec3 ab = 0.5F * (a + b), bc = 0.5F * (b + c);
    if (!is_quad()) {
      const Vec3 ca = 0.5F * (c + a);
      return {Patch{{a, ab, ca, ca}}, Patch{{ab, b, bc, bc}}, Patch{{ca, bc, c, c}}, Patch{{ab, bc, ca, ca}}};
    }
    const Vec3 cd = 0.5F * (c + d), da = 0.5F * (d + a), centre = 0.5F * (ab + cd);
    return {Patch{{a, ab, centre, da}}, Patch{{ab, b, bc, centre}}, Patch{{centre, bc, c, cd}}, Patch{{da, centre, cd, d}}};
  }

  /// The part that holds a point of the patch (of points outside, one that is near).
  std::size_t part_at(const Vec3& point, const Vec3& normal) const {
    const auto beyond = [&](const Vec3& from, const Vec3& to) {
      return glm::dot(glm::cross(to - from, point - from), normal) < 0.0F;
    };
    const auto& [a, b, c, d] = corners;
    const Vec3 ab = 0.5F * (a + b), bc = 0.5F * (b + c);
    if (!is_quad()) {
      const Vec3 ca = 0.5F * (c + a);
      return beyond(ca, ab) ? 0 : beyond(ab, bc) ? 1 : beyond(bc, ca) ? 2 : 3;
    }
    const Vec3 cd = 0.5F * (c + d), da = 0.5F * (d + a);
    const bool second = beyond(ab, cd), upper = beyond(bc, da);
    return upper ? (second ? 2 : 3) : (second ? 1 : 0);
  }

  /// A point by two numbers of the unit square; even by area in a triangle and in a parallelogram.
  Vec3 at(Vec2 u) const {
    const auto& [a, b, c, d] = corners;
    if (is_quad()) return (1.0F - u.y) * ((1.0F - u.x) * a + u.x * b) + u.y * ((1.0F - u.x) * d + u.x * c);
    if (u.x + u.y > 1.0F) u = Vec2(1.0F) - u;
    return a + u.x * (b - a) + u.y * (c - a);
  }

 private:
  float triangle_area() const { return 0.5F * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])); }
};

}  // namespace gibench::wavelet
