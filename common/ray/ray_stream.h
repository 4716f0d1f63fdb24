/// Counted rays: every ray of a run goes through a RayStream, which adds to the run's counts when it ends.
#pragma once

#include <atomic>
#include <cstdint>

#include "common/ray/ray_backend.h"

namespace gibench {

/// The rays that one run has traced.
struct RayCounts {
  std::atomic<std::uint64_t> closest_hit{0};
  std::atomic<std::uint64_t> occlusion{0};
};

/// One thread's tap on the backend, made per chunk of a loop; counts locally, adds once in its destructor.
class RayStream {
 public:
  RayStream(const RayBackend& backend, RayCounts& counts) : backend_(backend), counts_(counts) {}
  RayStream(const RayStream&) = delete;
  RayStream& operator=(const RayStream&) = delete;
  ~RayStream() {
    counts_.closest_hit.fetch_add(closest_hit_, std::memory_order_relaxed);
    counts_.occlusion.fetch_add(occlusion_, std::memory_order_relaxed);
  }

  Hit closest_hit(const Ray& ray) { return ++closest_hit_, backend_.closest_hit(ray); }
  bool occluded(const Ray& ray) { return ++occlusion_, backend_.occluded(ray); }
  void closest_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    closest_hit_ += rays.size();
    backend_.closest_hits(rays, hits);
  }
  void closest_hits(const RayFan& fan, const FanHits& hits) {
    closest_hit_ += fan.x.size();
    backend_.closest_hits(fan, hits);
  }
  void occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) {
    occlusion_ += rays.size();
    backend_.occlusions(rays, occluded);
  }

 private:
  const RayBackend& backend_;
  RayCounts& counts_;
  std::uint64_t closest_hit_ = 0, occlusion_ = 0;
};

}  // namespace gibench
