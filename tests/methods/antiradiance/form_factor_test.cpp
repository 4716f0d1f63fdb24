/// Form factors of discs against closed forms and quadrature.
#include "methods/antiradiance/form_factor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/core/random.h"

namespace gibench::antiradiance {
namespace {

Vec3 direction(RandomStream& random) {
  const float z = 2.0F * random.next_float() - 1.0F, phi = 2.0F * pi * random.next_float();
  const float r = std::sqrt(std::max(0.0F, 1.0F - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

Disc disc(RandomStream& random, float largest_radius) {
  const float radius = largest_radius * (0.1F + 0.9F * random.next_float());
  return {direction(random) * random.next_float(), direction(random), pi * radius * radius};
}

/// Midpoints of rings and sectors of equal area.
std::vector<Vec3d> points_of(const Disc& disc) {
  constexpr int rings = 12, sectors = 24;
  const Frame frame(disc.normal);
  std::vector<Vec3d> points;
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const double r = std::sqrt(static_cast<double>(disc.area) / pi_double * (ring + 0.5) / rings);
      const double phi = 2.0 * pi_double * (sector + 0.5 * (ring % 2)) / sectors;
      points.push_back(Vec3d(disc.centre) + Vec3d(frame.tangent) * (r * std::cos(phi)) +
                       Vec3d(frame.bitangent) * (r * std::sin(phi)));
    }
  return points;
}

double exchange_by_quadrature(const Disc& a, const Disc& b) {
  const auto from = points_of(a), to = points_of(b);
  double sum = 0.0;
  for (const Vec3d& x : from)
    for (const Vec3d& y : to) {
      const Vec3d d = y - x;
      const double squared = glm::dot(d, d);
      sum += glm::dot(Vec3d(a.normal), d) * -glm::dot(Vec3d(b.normal), d) / (squared * squared * pi_double);
    }
  return sum / static_cast<double>(from.size() * to.size()) * static_cast<double>(a.area) * static_cast<double>(b.area);
}

/// Howell C-41: coaxial parallel discs.
double coaxial(double distance, double radius, double other) {
  const double x = 1.0 + (distance * distance + other * other) / (radius * radius);
  return 0.5 * (x - std::sqrt(x * x - 4.0 * (other / radius) * (other / radius)));
}

TEST(DiscFormFactor, IsTheClosedFormOfCoaxialDiscsAtAnyDistance) {
  for (const double distance : {4.0, 8.0, 20.0, 1000.0})
    for (const double other : {0.1, 0.5, 1.0}) {
      const Disc a{Vec3(0.0F), {0.0F, 0.0F, 1.0F}, pi},
          b{{0.0F, 0.0F, static_cast<float>(distance)}, {0.0F, 0.0F, -1.0F}, pi * static_cast<float>(other * other)};
      EXPECT_NEAR(static_cast<double>(disc_form_factor(a, b)) / coaxial(distance, 1.0, other), 1.0, 0.01)
          << distance << ' ' << other;
    }
}

TEST(DiscFormFactor, IsWithinOnePerCentOfQuadratureBeyondFourRadii) {
  RandomStream random(1, 1, 1);
  int compared = 0;
  while (compared < 400) {
    Disc a{Vec3(0.0F), direction(random), pi}, b{Vec3(0.0F), direction(random), 0.0F};
    const float radius = std::pow(10.0F, -random.next_float());
    b.area = pi * radius * radius;
    const Vec3 way = direction(random);
    b.centre = way * (4.0F + 8.0F * random.next_float());
    if (glm::dot(a.normal, way) < 0.0F) a.normal = -a.normal;
    if (glm::dot(b.normal, way) > 0.0F) b.normal = -b.normal;
    // Neither disc may reach through the other's plane: there the integrand is cut off, and no smooth form is right.
    const float sine = std::sqrt(std::max(0.0F, 1.0F - std::pow(glm::dot(a.normal, b.normal), 2.0F)));
    if (glm::dot(a.normal, b.centre) < 1.02F * radius * sine || -glm::dot(b.normal, b.centre) < 1.02F * sine) continue;
    ++compared;
    EXPECT_NEAR(static_cast<double>(disc_exchange(a, b)) / exchange_by_quadrature(a, b), 1.0, 0.01);
  }
}

TEST(DiscFormFactor, IsReciprocalAndBoundedAtAnyDistance) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    RandomStream random(2, 1, i);
    Disc a = disc(random, 1.0F), b = disc(random, 1.0F);
    // Touching, nested, nearly and exactly coincident ones too.
    const float nearness = std::pow(10.0F, -7.0F * random.next_float());
    b.centre = i % 7 == 0 ? a.centre : a.centre + (b.centre - a.centre) * nearness;
    const double ab = static_cast<double>(disc_form_factor(a, b)), ba = static_cast<double>(disc_form_factor(b, a));
    ASSERT_TRUE(std::isfinite(ab) && ab >= 0.0 && ab <= 1.0 + 1e-6) << i << ' ' << ab;
    const double exchange = static_cast<double>(a.area) * ab, back = static_cast<double>(b.area) * ba;
    ASSERT_NEAR(exchange, back, 1e-5 * std::max(exchange, back)) << i;
  }
}

TEST(DiscFormFactor, FadesWithTheSquareOfTheDistance) {
  const Disc a{Vec3(0.0F), {0.0F, 0.0F, 1.0F}, 1e-4F};
  const auto at = [&](float distance) { return disc_form_factor(a, {{0.0F, 0.0F, distance}, {0.0F, 0.0F, -1.0F}, 1.0F}); };
  EXPECT_NEAR(at(1e3F) * 1e6F, 1.0F / pi, 1e-4F);
  EXPECT_NEAR(at(1e3F) / at(2e3F), 4.0F, 1e-3F);
}

}  // namespace
}  // namespace gibench::antiradiance
