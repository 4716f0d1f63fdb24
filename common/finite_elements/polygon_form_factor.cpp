#include "common/finite_elements/polygon_form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "common/core/error.h"

namespace gibench {

namespace {

constexpr std::size_t most_corners = 6;

/// Keeps what lies on the positive side of the plane through the origin (Sutherland and Hodgman 1974); `corners` relative
/// to the point. One more corner than before at most.
std::size_t clip_to_hemisphere(const Vec3& normal, std::span<const Vec3> corners, std::array<Vec3, most_corners + 1>& kept) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const float height_a = glm::dot(normal, a), height_b = glm::dot(normal, b);
    if (height_a >= 0.0F && count < kept.size()) kept[count++] = a;
    if ((height_a < 0.0F) != (height_b < 0.0F) && height_a != height_b && count < kept.size())
      kept[count++] = a + (b - a) * (height_a / (height_a - height_b));
  }
  return count;
}

}  // namespace

float polygon_form_factor(const Vec3& point, const Vec3& normal, std::span<const Vec3> corners) {
  std::array<Vec3, most_corners> relative{};
  const std::size_t given = corners.size();
  GIBENCH_CHECK(given <= most_corners, "a polygon has at most 6 corners");
  for (std::size_t i = 0; i < given; ++i) relative[i] = corners[i] - point;
  std::array<Vec3, most_corners + 1> kept{};
  const std::size_t count = clip_to_hemisphere(normal, std::span(relative).first(given), kept);
  if (count < 3) return 0.0F;
  float sum = 0.0F;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &a = kept[i], &b = kept[(i + 1) % count];
    const Vec3 across = glm::cross(a, b - a);  // of nearly parallel a and b their own product would lose its digits
    const float length = glm::length(across);
    // The point on the edge itself: the edge's plane holds no angle about the normal.
    if (!(length > 0.0F)) continue;
    sum += std::atan2(length, glm::dot(a, b)) * glm::dot(across, normal) / length;
  }
  return std::clamp(std::fabs(sum) * (0.5F / pi), 0.0F, 1.0F);
}

}  // namespace gibench
