#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

TEST(InputError, IsOneLineOfPlaceProblemAndMend) {
  EXPECT_STREQ(InputError("a.json /x", "is\nwrong", "write\r\n1").what(), "a.json /x: is wrong; write  1");
  EXPECT_STREQ(InputError("a.json", "is wrong").what(), "a.json: is wrong");
}

TEST(Check, ThrowsTheMessage) {
  GIBENCH_CHECK(1 + 1 == 2, "arithmetic holds");
  EXPECT_THAT([&] { GIBENCH_CHECK(1 + 1 == 3, "arithmetic fails"); }, test::fails_check("check failed: arithmetic fails"));
}

TEST(Rgb, ArithmeticIsByChannel) {
  const Rgb a(1, 2, 3), b(4, 5, 6);
  EXPECT_EQ(a + b, Rgb(5, 7, 9));
  EXPECT_EQ(b - a, Rgb(3, 3, 3));
  EXPECT_EQ(a * b, Rgb(4, 10, 18));
  EXPECT_EQ(2.0F * a, Rgb(2, 4, 6));
  EXPECT_EQ(b / 2.0F, Rgb(2, 2.5F, 3));
  EXPECT_EQ(largest(a), 3.0F);
  EXPECT_EQ(smallest(a), 1.0F);
  EXPECT_EQ(a[0] + a[1] * 10 + a[2] * 100, 321.0F);
  EXPECT_FLOAT_EQ(luminance(Rgb(1.0F)), 1.0F);
  EXPECT_TRUE(is_black(Rgb()));
  EXPECT_FALSE(is_black(Rgb(0, 0, 1)));
  EXPECT_FALSE(is_finite(Rgb(0, std::numeric_limits<float>::quiet_NaN(), 0)));
  EXPECT_FALSE(is_finite(Rgb(0, 0, INFINITY)));
}

TEST(Frame, IsRightHandedAndOrthonormalForEveryNormal) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    RandomStream random(1, 0, i);
    Vec3 normal(random.next_float() - 0.5F, random.next_float() - 0.5F, random.next_float() - 0.5F);
    if (i == 0) normal = {0, 0, 1};
    if (i == 1) normal = {0, 0, -1};
    if (i == 2) normal = {0, 1e-6F, -1};
    const Frame frame(glm::normalize(normal));
    EXPECT_NEAR(glm::length(frame.tangent), 1.0F, 2e-6F);
    EXPECT_NEAR(glm::dot(frame.tangent, frame.bitangent), 0.0F, 2e-6F);
    EXPECT_LT(glm::distance(glm::cross(frame.tangent, frame.bitangent), frame.normal), 3e-6F);
    const Vec3 local(0.1F, -0.7F, 0.4F);
    EXPECT_LT(glm::distance(frame.to_local(frame.to_world(local)), local), 2e-6F);
  }
}

}  // namespace
}  // namespace gibench
