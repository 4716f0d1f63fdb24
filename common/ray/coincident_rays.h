/// A ray backend that meets, where triangles coincide, the one that is in front.
#pragma once

#include <memory>

#include "common/ray/coincident_faces.h"
#include "common/ray/ray_backend.h"

namespace gibench {

/// Passes rays on to another backend and settles what they met. Occlusions need no settling.
class CoincidentRays final : public RayBackend {
 public:
  /// Both must outlive this.
  CoincidentRays(const RayBackend& rays, const CoincidentFaces& faces) : rays_(rays), faces_(faces) {}
  std::size_t bytes() const override { return rays_.bytes(); }

 private:
  void do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const override;
  void do_occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    rays_.occlusions(rays, occluded);
  }
  void do_fan_hits(const RayFan& fan, const FanHits& hits) const override;
  Hit do_closest_hit(const Ray& ray) const override { return faces_.in_front(rays_.closest_hit(ray), ray.direction); }
  bool do_occluded(const Ray& ray) const override { return rays_.occluded(ray); }

  const RayBackend& rays_;
  const CoincidentFaces& faces_;
};

}  // namespace gibench
