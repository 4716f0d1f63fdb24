/// Cameras as frames: which way a place in the picture lies, and which points are in it.
#pragma once

#include <vector>

#include "common/core/vec.h"
#include "common/scene/scene.h"

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

}  // namespace gibench
