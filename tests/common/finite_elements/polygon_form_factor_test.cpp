/// Form factors of polygons against closed forms.
#include "common/finite_elements/polygon_form_factor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

}  // namespace
}  // namespace gibench
