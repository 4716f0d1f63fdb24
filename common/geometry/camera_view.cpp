#include "common/geometry/camera_view.h"

#include <cmath>

namespace gibench {

CameraView::CameraView(const Camera& camera)
    : position(camera.position),
      forward(glm::normalize(camera.look_at - camera.position)),
      right(glm::normalize(glm::cross(forward, camera.up))),
      up(glm::cross(right, forward)),
      half_height(std::tan(0.5F * camera.vertical_fov_degrees * pi / 180.0F)) {
  half_width = half_height * static_cast<float>(camera.width) / static_cast<float>(camera.height);
}

bool CameraView::in_picture(const Vec3& point) const {
  const Vec3 away = point - position;
  const float depth = glm::dot(away, forward);
  return depth > 0.0F && std::abs(glm::dot(away, right)) <= depth * half_width &&
         std::abs(glm::dot(away, up)) <= depth * half_height;
}

std::vector<CameraView> camera_views(const Scene& scene) { return {scene.cameras.begin(), scene.cameras.end()}; }

}  // namespace gibench
