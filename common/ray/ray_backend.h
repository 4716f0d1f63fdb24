/// The Embree backend: closest hit and occlusion, one by one and in batches. ray_backend.cpp is the only file
/// that includes Embree.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

struct Ray {
  Vec3 origin;
  float t_min = 0.0F;
  Vec3 direction;  ///< need not be unit; distances are in its length
  float t_max = std::numeric_limits<float>::infinity();
};

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

/// A bounding volume hierarchy over the scene's triangles; immutable, shared by all threads. Robust mode.
class RayBackend {
 public:
  explicit RayBackend(const Scene& scene, int threads = 0);
  ~RayBackend();
  RayBackend(RayBackend&&) noexcept;

  Hit closest_hit(const Ray& ray) const;
  /// Whether anything lies in (t_min, t_max).
  bool occluded(const Ray& ray) const;
  /// Batches, traced in packets in the order given: equal to one by one up to rounding of the distance.
  void closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const;
  void occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const;
  /// The same hits, for rays that lie in columns as packets want them.
  void closest_hits(const RayFan& fan, const FanHits& hits) const;

  /// Bytes that Embree holds for the hierarchy.
  std::size_t bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gibench
