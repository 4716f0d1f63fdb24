/// Small vectors (GLM) and the local frame of a surface point.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace gibench {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;  ///< position (metres, relative to Scene::origin) or direction
using Vec3d = glm::dvec3;

inline constexpr float pi = 3.14159265358979323846F;
inline constexpr double pi_double = 3.14159265358979323846;

inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline float max_abs(const Vec3& v) { return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z))); }

/// Right-handed orthonormal frame whose z axis is `normal` (Duff et al. 2017, listing 3).
struct Frame {
  Vec3 tangent, bitangent, normal;

  explicit Frame(const Vec3& unit_normal) : normal(unit_normal) {
    const float sign = std::copysign(1.0F, normal.z);
    const float a = -1.0F / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    tangent = {1.0F + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
    bitangent = {b, sign + normal.y * normal.y * a, -normal.y};
  }

  Vec3 to_world(const Vec3& local) const { return local.x * tangent + local.y * bitangent + local.z * normal; }
  Vec3 to_local(const Vec3& world) const {
    return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
  }
};

}  // namespace gibench
