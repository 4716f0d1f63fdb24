/// Embree alone: the simplest loops over the same rays, with which the project's ray backend is compared.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "common/ray/ray.h"
#include "common/scene/scene.h"

namespace gibench::micro {

/// The scene's triangles in an Embree scene built as the ray backend builds its own: robust, medium quality.
class BareEmbree {
 public:
  explicit BareEmbree(const Scene& scene);
  ~BareEmbree();
  BareEmbree(const BareEmbree&) = delete;
  BareEmbree& operator=(const BareEmbree&) = delete;

  /// One ray after another; gives the sum of the triangles hit plus one, so that nothing is optimised away.
  std::uint64_t closest_hits(std::span<const Ray> rays) const;
  /// The same for occlusion; gives the number of rays that something stops.
  std::uint64_t occlusions(std::span<const Ray> rays) const;
  /// In packets of 8 or 16 rays, a whole number of packets.
  template <std::size_t width>
  std::uint64_t closest_hits_in_packets(std::span<const Ray> rays) const;
  template <std::size_t width>
  std::uint64_t occlusions_in_packets(std::span<const Ray> rays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gibench::micro
