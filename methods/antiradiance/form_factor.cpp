#include "methods/antiradiance/form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gibench::antiradiance {

namespace {

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

}  // namespace gibench::antiradiance
