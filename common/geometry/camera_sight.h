/// The question whether a camera of the scene sees a point, directly or by one diffuse reflection.
#pragma once

#include <vector>

#include "common/core/random.h"
#include "common/geometry/camera_view.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"

namespace gibench {

/// What the cameras of a world see.
class CameraSight {
 public:
  /// Keeps a reference to the world.
  explicit CameraSight(const World& world) : world_(world), views_(camera_views(world.scene())) {}

  /// In the picture of a camera, its side turned to it, and nothing between.
  bool sees(const SurfaceSample& sample) const;
  /// The same by counted rays.
  bool sees(const SurfaceSample& sample, RayStream& rays) const;
  /// One of 16 cosine-distributed rays from the sample meets a lit side that a camera sees.
  bool sees_reflection_to(const SurfaceSample& sample, RandomStream& random) const;

 private:
  const World& world_;
  std::vector<CameraView> views_;
};

}  // namespace gibench
