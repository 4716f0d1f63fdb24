#include "methods/antiradiance/form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gibench::antiradiance {

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

constexpr float near_radii = 8.0F;  // of the larger disc; nearer than that discs are cut into four
constexpr std::size_t parts = 4;

/// Both on their positive sides; nothing where either lies behind the other.
float exchange_of_facing(const Disc& i, const Disc& j) {
  const Vec3 d = j.centre - i.centre;
  const float squared = glm::dot(d, d);
  if (!(squared > 0.0F)) return 0.0F;
  const float to_unit = 1.0F / std::sqrt(squared);
  const float u = glm::dot(i.normal, d) * to_unit, v = -glm::dot(j.normal, d) * to_unit;
  if (!(u > 0.0F && v > 0.0F)) return 0.0F;
  const float s = pi * squared + i.area + j.area;
  return coaxial_exchange(squared, i.area, j.area) *
         orientation_factor(u, v, glm::dot(i.normal, j.normal), i.area / s, j.area / s);
}

/// Four discs with a quarter of the area each, on the circle of radius a √(3/8): with their own, they have the disc's second
/// moments, so that functions up to the third order have its mean.
std::array<Disc, parts> quarters(const Disc& disc) {
  const Frame frame(disc.normal);
  const float offset = std::sqrt(disc.area / pi * 0.375F);
  std::array<Disc, parts> result;
  for (std::size_t k = 0; k < parts; ++k) {
    const Vec3& axis = k < 2 ? frame.tangent : frame.bitangent;
    result[k] = {disc.centre + axis * (k % 2 == 0 ? offset : -offset), disc.normal, disc.area / static_cast<float>(parts)};
  }
  return result;
}

}  // namespace

float disc_exchange(const Disc& i, const Disc& j) {
  const Vec3 d = j.centre - i.centre;
  const float sign_i = glm::dot(i.normal, d) < 0.0F ? -1.0F : 1.0F, sign_j = glm::dot(j.normal, d) > 0.0F ? -1.0F : 1.0F;
  const Disc from{i.centre, i.normal * sign_i, i.area}, to{j.centre, j.normal * sign_j, j.area};
  if (pi * glm::dot(d, d) > near_radii * near_radii * std::max(i.area, j.area)) return exchange_of_facing(from, to);
  float sum = 0.0F;
  for (const Disc& a : quarters(from))
    for (const Disc& b : quarters(to)) sum += exchange_of_facing(a, b);
  return std::min(sum, std::min(i.area, j.area));
}

float polygon_form_factor(const Vec3& point, const Vec3& normal, std::span<const Vec3> corners) {
  std::array<Vec3, most_corners> relative{};
  const std::size_t given = std::min(corners.size(), most_corners);
  for (std::size_t i = 0; i < given; ++i) relative[i] = corners[i] - point;
  std::array<Vec3, most_corners + 1> kept{};
  const std::size_t count = clip_to_hemisphere(normal, std::span(relative).first(given), kept);
  if (count < 3) return 0.0F;
  float sum = 0.0F;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &a = kept[i], &b = kept[(i + 1) % count];
    const Vec3 across = glm::cross(a, b);
    const float length = glm::length(across);
    // The point on the edge itself: the edge's plane holds no angle about the normal.
    if (!(length > 0.0F)) continue;
    sum += std::atan2(length, glm::dot(a, b)) * glm::dot(across, normal) / length;
  }
  return std::clamp(std::fabs(sum) * (0.5F / pi), 0.0F, 1.0F);
}

}  // namespace gibench::antiradiance
