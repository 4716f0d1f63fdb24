#include "methods/antiradiance/bins.h"

#include <algorithm>
#include <cmath>

namespace gibench::antiradiance {

namespace {

constexpr int whole = 255;  // of a mask

/// Unit direction to the square [-1, 1]². Clarberg 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD".
Vec2 to_square(const Vec3& w) {
  const float r = std::sqrt(std::max(0.0F, 1.0F - std::fabs(w.z)));
  const float x = std::fabs(w.x), y = std::fabs(w.y);
  const float phi = (x == 0.0F && y == 0.0F) ? 0.0F : std::atan2(y, x) * (2.0F / pi);
  float v = phi * r, u = r - v;
  if (w.z < 0.0F) {
    const float folded = u;
    u = 1.0F - v;
    v = 1.0F - folded;
  }
  return {std::copysign(u, w.x), std::copysign(v, w.y)};
}

Vec3 to_direction(float u, float v) {
  const float up = std::fabs(u), vp = std::fabs(v);
  const float signed_distance = 1.0F - (up + vp);
  const float r = 1.0F - std::fabs(signed_distance);
  const float phi = (r == 0.0F ? 1.0F : (vp - up) / r + 1.0F) * (pi / 4.0F);
  const float z = std::copysign(1.0F - r * r, signed_distance);
  const float scale = r * std::sqrt(std::max(0.0F, 2.0F - r * r));
  return {std::copysign(std::cos(phi), u) * scale, std::copysign(std::sin(phi), v) * scale, z};
}

}  // namespace

DirectionBins::DirectionBins(int resolution) : resolution_(resolution) {
  const float step = 2.0F / static_cast<float>(resolution);
  for (int row = 0; row < resolution; ++row)
    for (int column = 0; column < resolution; ++column)
      directions_.push_back(glm::normalize(
          to_direction((static_cast<float>(column) + 0.5F) * step - 1.0F, (static_cast<float>(row) + 0.5F) * step - 1.0F)));
  for (int row = -1; row < resolution; ++row)
    for (int column = -1; column < resolution; ++column)
      quads_.push_back({bin_at(column, row), bin_at(column + 1, row), bin_at(column, row + 1), bin_at(column + 1, row + 1)});
  least_cosine_ = std::sqrt(solid_angle() / pi) / 3.0F;
}

/// Beyond a side of the square its other half goes on, mirrored.
std::uint16_t DirectionBins::bin_at(int column, int row) const {
  const int last = resolution_ - 1;
  if (column < 0 || column > last) row = last - row, column = std::clamp(column, 0, last);
  if (row < 0 || row > last) column = last - column, row = std::clamp(row, 0, last);
  return static_cast<std::uint16_t>(row * resolution_ + column);
}

DirectionBins::Place DirectionBins::place(const Vec3& direction) const {
  const Vec2 at = (to_square(direction) + 1.0F) * (0.5F * static_cast<float>(resolution_)) - 0.5F;
  const float column = std::clamp(std::floor(at.x), -1.0F, static_cast<float>(resolution_ - 1));
  const float row = std::clamp(std::floor(at.y), -1.0F, static_cast<float>(resolution_ - 1));
  const float x = std::clamp(at.x - column, 0.0F, 1.0F), y = std::clamp(at.y - row, 0.0F, 1.0F);
  Place result;
  result.quad = static_cast<std::uint16_t>((static_cast<int>(row) + 1) * (resolution_ + 1) + static_cast<int>(column) + 1);
  result.shares = {(1.0F - x) * (1.0F - y), x * (1.0F - y), (1.0F - x) * y, x * y};
  return result;
}

std::uint16_t DirectionBins::bin_of(const Place& place) const {
  const auto largest = std::max_element(place.shares.begin(), place.shares.end()) - place.shares.begin();
  return quads_[place.quad][static_cast<std::size_t>(largest)];
}

DirectionMask DirectionBins::mask(const Place& place, const Vec3& normal, float sign) const {
  const auto& bins = quads_[place.quad];
  std::array<float, 4> shares{};
  float sum = 0.0F;
  std::size_t nearest = 0;
  float height_of_nearest = -2.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    const float height = sign * glm::dot(normal, directions_[bins[k]]);
    shares[k] = height > 0.0F ? place.shares[k] : 0.0F;
    sum += shares[k];
    if (height > height_of_nearest) nearest = k, height_of_nearest = height;
  }
  DirectionMask mask;
  if (!(sum > 0.0F)) {  // all four lie beyond the plane: the one that does so least
    mask.weights[nearest] = whole;
    return mask;
  }
  int left = whole;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const int weight = static_cast<int>(shares[k] / sum * static_cast<float>(whole));
    mask.weights[k] = static_cast<std::uint8_t>(weight);
    left -= weight;
    if (shares[k] > shares[largest]) largest = k;
  }
  mask.weights[largest] = static_cast<std::uint8_t>(mask.weights[largest] + left);
  return mask;
}

}  // namespace gibench::antiradiance
