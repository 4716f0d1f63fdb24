#include "common/reflectance/spherical_harmonics.h"

#include <cmath>

namespace gibench {

namespace {

constexpr std::size_t rings = 4, ring_size = 7;  // Gauss points in z, evenly spaced azimuths

struct QuadraturePoint {
  Vec3 direction;
  float weight;  // sr
  Harmonics harmonics;
};

/// Exact for polynomials up to degree 6 in the direction: for products of two functions of the first four bands.
std::array<QuadraturePoint, rings * ring_size> quadrature() {
  constexpr std::array<double, rings> height{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  constexpr std::array<double, rings> weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  std::array<QuadraturePoint, rings * ring_size> points;
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (std::size_t i = 0; i < ring_size; ++i) {
      const double azimuth = 2.0 * pi_double * static_cast<double>(i) / ring_size,
                   radius = std::sqrt(1.0 - height[ring] * height[ring]);
      const Vec3 direction(radius * std::cos(azimuth), radius * std::sin(azimuth), height[ring]);
      points[ring * ring_size + i] = {direction, static_cast<float>(weight[ring] * 2.0 * pi_double / ring_size),
                                      spherical_harmonics(direction)};
    }
  return points;
}

}  // namespace

RgbHarmonics to_world(const RgbHarmonics& local, const Frame& frame) {
  static const auto points = quadrature();
  RgbHarmonics world{};
  for (const QuadraturePoint& point : points) {
    Rgb value;
    for (std::size_t k = 0; k < harmonic_count; ++k) value += local[k] * point.harmonics[k];
    value *= point.weight;
    const Harmonics there = spherical_harmonics(frame.to_world(point.direction));
    for (std::size_t k = 0; k < harmonic_count; ++k) world[k] += value * there[k];
  }
  return world;
}

}  // namespace gibench
