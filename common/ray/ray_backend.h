/// The interface of a ray backend: closest hits and occlusions of batches of rays; single rays and fans stand on these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "common/core/error.h"
#include "common/ray/ray.h"
#include "common/scene/scene.h"

namespace gibench {

/// Finds what rays meet among triangles. Immutable once it is made, shared by all threads. A backend has to write the two
/// batches; it writes the rest as well where it has a faster way.
class RayBackend {
 public:
  RayBackend() = default;
  RayBackend(const RayBackend&) = delete;
  RayBackend& operator=(const RayBackend&) = delete;
  virtual ~RayBackend() = default;

  /// The nearest triangle in (t_min, t_max) of every ray, from either side.
  void closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const {
    GIBENCH_CHECK(rays.size() == hits.size(), "one hit for each ray");
    do_closest_hits(rays, hits);
  }
  /// 1 where anything lies in (t_min, t_max), else 0.
  void occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
    GIBENCH_CHECK(rays.size() == occluded.size(), "one answer for each ray");
    do_occlusions(rays, occluded);
  }
  /// The same hits, for rays that lie in columns as packets want them.
  void closest_hits(const RayFan& fan, const FanHits& hits) const {
    const std::size_t total = fan.x.size();
    GIBENCH_CHECK(fan.y.size() == total && fan.z.size() == total && hits.triangle.size() == total && hits.u.size() == total &&
                      hits.v.size() == total,
                  "the columns of a fan are of one length");
    do_fan_hits(fan, hits);
  }

  /// One ray: equal to a batch up to rounding of the distance.
  Hit closest_hit(const Ray& ray) const { return do_closest_hit(ray); }
  bool occluded(const Ray& ray) const { return do_occluded(ray); }

  /// Bytes that the backend holds.
  virtual std::size_t bytes() const = 0;

 private:
  virtual void do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const = 0;
  virtual void do_occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const = 0;
  virtual void do_fan_hits(const RayFan& fan, const FanHits& columns) const {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < fan.x.size(); ++i) rays.push_back({fan.origin, 0.0F, {fan.x[i], fan.y[i], fan.z[i]}});
    std::vector<Hit> hits(rays.size());
    do_closest_hits(rays, hits);
    for (std::size_t i = 0; i < hits.size(); ++i)
      columns.triangle[i] = hits[i].triangle, columns.u[i] = hits[i].u, columns.v[i] = hits[i].v;
  }
  virtual Hit do_closest_hit(const Ray& ray) const {
    Hit hit;
    do_closest_hits({&ray, 1}, {&hit, 1});
    return hit;
  }
  virtual bool do_occluded(const Ray& ray) const {
    std::uint8_t occluded = 0;
    do_occlusions({&ray, 1}, {&occluded, 1});
    return occluded != 0;
  }
};

/// Makes a backend for triangles with `threads` threads (0: all cores). The backend keeps no reference to the arrays.
/// Throws WorkError.
using MakeRayBackend = std::function<std::unique_ptr<const RayBackend>(std::span<const Vec3> vertices,
                                                                       std::span<const Triangle> triangles, int threads)>;

}  // namespace gibench
