/// Form factors of polygons against closed forms.
#include "common/finite_elements/polygon_form_factor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/core/error.h"

namespace gibench {
namespace {

TEST(PolygonFormFactor, IsTheClosedFormOfAParallelSquare) {
  // Howell B-3: element under a corner of a rectangle, unit sides, unit distance.
  const double a = 1.0 / std::sqrt(2.0);
  const double corner = (a * std::atan(a) + a * std::atan(a)) / (2.0 * pi_double);
  const std::array<Vec3, 4> square{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
  EXPECT_NEAR(static_cast<double>(polygon_form_factor(Vec3(0.0F), {0.0F, 0.0F, 1.0F}, square)), corner, 1e-6);
  EXPECT_NEAR(static_cast<double>(polygon_form_factor({0.5F, 0.5F, 1.0F - 1e-4F}, {0.0F, 0.0F, 1.0F}, square)), 1.0, 1e-3);
}

TEST(PolygonFormFactor, ClipsToTheHemisphere) {
  // A tall, wide wall at the point's feet hides half of the hemisphere; its part below the ground adds nothing.
  const std::array<Vec3, 4> wall{Vec3(1e-3F, -1e3F, -1e3F), Vec3(1e-3F, 1e3F, -1e3F), Vec3(1e-3F, 1e3F, 1e3F),
                                 Vec3(1e-3F, -1e3F, 1e3F)};
  EXPECT_NEAR(polygon_form_factor(Vec3(0.0F), {0.0F, 0.0F, 1.0F}, wall), 0.5F, 1e-3F);
}

TEST(PolygonFormFactor, KeepsItsDigitsOfWhatIsFarAway) {
  // A square of a thousandth at distance one, turned about the ray to it: area times cosine over pi.
  for (int step = 0; step < 32; ++step) {
    const float turn = 0.1F * static_cast<float>(step), side = 1e-3F;
    const Vec3 middle = glm::normalize(Vec3(0.3F, -0.2F, 0.9F)), across = glm::normalize(glm::cross(middle, Vec3(0, 1, 0)));
    const Vec3 up = glm::cross(middle, across);
    const Vec3 u = 0.5F * side * (std::cos(turn) * across + std::sin(turn) * up),
               v = 0.5F * side * (std::cos(turn) * up - std::sin(turn) * across);
    const std::array<Vec3, 4> square{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
    const float expected = side * side * middle.z / pi;
    EXPECT_NEAR(polygon_form_factor(Vec3(0.0F), {0.0F, 0.0F, 1.0F}, square), expected, 2e-3F * expected) << turn;
  }
}

TEST(PolygonFormFactor, RefusesMoreThanSixCorners) {
  std::array<Vec3, 7> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float angle = 2.0F * pi * static_cast<float>(i) / 7.0F;
    corners[i] = {std::cos(angle), std::sin(angle), 1.0F};
  }
  EXPECT_THROW(polygon_form_factor(Vec3(0.0F), {0.0F, 0.0F, 1.0F}, corners), CheckFailed);
}

}  // namespace
}  // namespace gibench
