/// Rays, and what they meet.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "common/core/vec.h"

namespace gibench {

/// The points origin + t direction with t from t_min to t_max.
struct Ray {
  Vec3 origin;
  float t_min = 0.0F;
  Vec3 direction;  ///< need not be unit; distances are in its length
  float t_max = std::numeric_limits<float>::infinity();
};

/// The nearest point that a ray meets; false where it meets nothing.
struct Hit {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::uint32_t triangle = none;  ///< index into Scene::triangles
  float u = 0.0F, v = 0.0F;       ///< barycentrics of the triangle's second and third corner
  float distance = 0.0F;          ///< in lengths of the ray's direction
  explicit operator bool() const { return triangle != none; }
};

/// Rays from one point, their directions in columns of one length; t from 0 to infinity.
struct RayFan {
  Vec3 origin;
  std::span<const float> x, y, z;  ///< of the directions
};

/// What a fan's rays meet, in columns as long as the fan: Hit without the distance.
struct FanHits {
  std::span<std::uint32_t> triangle;
  std::span<float> u, v;  ///< undefined where no triangle is met
};

}  // namespace gibench
