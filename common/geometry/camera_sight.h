/// Cameras as frames, and whether one of them sees a point, directly or by one diffuse reflection.
#pragma once

#include <vector>

#include "common/core/random.h"
#include "common/ray/world.h"

namespace gibench {

/// A camera's frame; the picture spans -1 to 1 in both directions.
struct CameraView {
  Vec3 position, forward;
  Vec3 right, up;  ///< unit; half the picture's width and height at distance 1 are their scales
  float half_width = 1.0F, half_height = 1.0F;

  explicit CameraView(const Camera& camera);
  /// Not unit.
  Vec3 direction_at(float across, float upward) const {
    return forward + across * half_width * right + upward * half_height * up;
  }
  bool in_picture(const Vec3& point) const;
};
std::vector<CameraView> camera_views(const Scene& scene);

/// What the cameras of a world see.
class CameraSight {
 public:
  /// Keeps a reference to the world.
  explicit CameraSight(const World& world) : world_(world), views_(camera_views(world.scene())) {}

  /// In the picture of a camera, its side turned to it, and nothing between.
  bool sees(const SurfaceSample& sample) const;
  /// One of 16 cosine-distributed rays from the sample meets a lit side that a camera sees.
  bool sees_reflection_to(const SurfaceSample& sample, RandomStream& random) const;

 private:
  const World& world_;
  std::vector<CameraView> views_;
};

}  // namespace gibench
