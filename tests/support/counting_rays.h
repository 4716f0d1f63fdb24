/// A ray backend that counts the calls that rays come in.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "common/ray/world.h"

namespace gibench::test {

/// Traces the rays of another world of the same shape, which must outlive it.
class CountingRays final : public RayBackend {
 public:
  CountingRays(const RayBackend& rays, std::atomic<std::uint64_t>& calls) : rays_(rays), calls_(calls) {}
  std::size_t bytes() const override { return 0; }

 private:
  void do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const override {
    ++calls_;
    rays_.closest_hits(rays, hits);
  }
  void do_occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    ++calls_;
    rays_.occlusions(rays, occluded);
  }

  const RayBackend& rays_;
  std::atomic<std::uint64_t>& calls_;
};

/// A scene whose rays' calls are counted.
struct CountedWorld {
  explicit CountedWorld(const Scene& scene)
      : plain(scene, 1), world(scene, 1, [this](std::span<const Vec3>, std::span<const Triangle>, int) {
          return std::make_unique<CountingRays>(plain.rays(), calls);
        }) {}

  std::atomic<std::uint64_t> calls = 0;
  World plain, world;
};

}  // namespace gibench::test
