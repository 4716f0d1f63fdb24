#include "common/finite_elements/inside_geometry.h"

#include <gtest/gtest.h>

#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

/// A room that holds a block: rays from within the block meet its back.
class InsideGeometry : public testing::TestWithParam<bool> {
 protected:
  InsideGeometry() : world_(scene(GetParam())) {}

  static Scene scene(bool two_sided) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
    builder.room("room", white, Vec3(0.0F), Vec3(4.0F));
    const auto cube = [](float x, float y, float z) { return Vec3(1.0F + x, 1.0F + y, 1.0F + z); };
    builder.object(
        "block", white,
        {cube(0, 0, 0), cube(1, 0, 0), cube(1, 1, 0), cube(0, 1, 0), cube(0, 0, 1), cube(1, 0, 1), cube(1, 1, 1), cube(0, 1, 1)},
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}}, two_sided);
    return builder.build("block in a room");
  }

  bool inside(const Vec3& point, int rays, int& asked) {
    RayCounts counts;
    RayStream stream(world_.rays(), counts);
    return all_meet_black_backs(world_, point, 0, rays, stream, [&](int ray) {
      ++asked;
      return glm::normalize(Vec3(1.0F, 0.3F * static_cast<float>(ray), -0.2F));
    });
  }

  World world_;
};

TEST_P(InsideGeometry, IsFoundByBacks) {
  int asked = 0;
  EXPECT_EQ(inside(Vec3(1.5F), 8, asked), !GetParam());  // both sides of a two-sided block are lit
  EXPECT_EQ(asked, GetParam() ? 1 : 8);
}

TEST_P(InsideGeometry, OneRayThatMeetsAFrontEndsTheTest) {
  int asked = 0;
  EXPECT_FALSE(inside(Vec3(3.0F), 8, asked));
  EXPECT_EQ(asked, 1);
}

INSTANTIATE_TEST_SUITE_P(OneAndTwoSided, InsideGeometry, testing::Bool());

}  // namespace
}  // namespace gibench
