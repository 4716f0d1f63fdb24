#include "methods/meshless/weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/core/random.h"
#include "methods/meshless/box_tree.h"
#include "methods/meshless/packed_normal.h"
#include "tests/support/random_direction.h"

namespace gibench::meshless {
namespace {

Vec3 random_direction(std::uint64_t index) { return gibench::test::random_direction(0, index); }

TEST(Weights, KernelIsThatOfEquation13) {
  EXPECT_FLOAT_EQ(kernel(0.0F), 1.0F);
  EXPECT_FLOAT_EQ(kernel(1.0F), 0.0F);
  for (float r : {0.1F, 0.5F, 0.9F}) EXPECT_NEAR(kernel(r * r), 2.0F * r * r * r - 3.0F * r * r + 1.0F, 1e-6F);
}

TEST(Weights, FallsWithDistanceAndAngleAndEndsAtTheBall) {
  EXPECT_FLOAT_EQ(weight(0.0F, 2.0F, 1.0F), 1.0F);
  EXPECT_FLOAT_EQ(weight(1.0F, 2.0F, 0.5F), 0.25F);
  EXPECT_EQ(weight(4.0F, 2.0F, 1.0F), 0.0F);
  EXPECT_EQ(weight(9.0F, 2.0F, 1.0F), 0.0F);
  EXPECT_EQ(weight(0.0F, 2.0F, 0.0F), 0.0F);
  EXPECT_EQ(weight(0.0F, 2.0F, -1.0F), 0.0F);
}

TEST(PackedNormal, IsExactOnTheAxesAndGoodToHalfAStepElsewhere) {
  for (int axis = 0; axis < 3; ++axis)
    for (float sign : {-1.0F, 1.0F}) {
      Vec3 unit(0.0F);
      unit[axis] = sign;
      EXPECT_EQ(unpack_normal(pack_normal(unit)), unit);
    }
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec3 unit = random_direction(i);
    EXPECT_LT(glm::distance(unpack_normal(pack_normal(unit)), unit), 6.6e-5F);  // the header derives 6.5e-5, and rounding
  }
}

struct Balls {
  std::vector<Vec3> centres;
  std::vector<float> radii;
  std::vector<Box> boxes;  ///< of blocks of eight
};

Balls random_balls(std::size_t count) {
  std::vector<Vec3> centres;
  for (std::uint64_t i = 0; i < count; ++i) {
    RandomStream random(8, 1, i);
    const float x = random.next_float(), y = random.next_float(), z = random.next_float();
    centres.push_back({x, y, 0.1F * z});
  }
  Balls balls;
  for (std::uint32_t i : compact_order(centres)) {
    balls.centres.push_back(centres[i]);
    balls.radii.push_back(0.01F + 0.05F * RandomStream(8, 2, i).next_float());
  }
  balls.boxes.resize((count + 7) / 8);
  for (std::size_t i = 0; i < count; ++i) balls.boxes[i / 8].add(balls.centres[i], balls.radii[i]);
  return balls;
}

TEST(CompactOrder, IsAPermutationOfSmallBlocks) {
  const Balls balls = random_balls(5003);
  std::vector<Vec3> positions = balls.centres;
  const std::vector<std::uint32_t> order = compact_order(positions);
  std::vector<std::uint8_t> seen(positions.size(), 0);
  for (std::uint32_t i : order) ++seen[i];
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](std::uint8_t n) { return n == 1; }));
  double sizes = 0.0;
  for (std::size_t block = 0; block + 1 < positions.size() / 8; ++block) {
    Box box;
    for (std::size_t i = 0; i < 8; ++i) box.add(positions[order[block * 8 + i]], 0.0F);
    sizes += static_cast<double>(glm::length(box.high - box.low));
  }
  EXPECT_LT(sizes / (static_cast<double>(positions.size()) / 8.0), 0.12);  // spread evenly, eight points span 0.06 … 0.1
}

TEST(BoxTree, FindsEveryLeafThatHoldsAPoint) {
  for (std::size_t count : {1U, 8U, 9U, 65U, 3000U}) {
    const Balls balls = random_balls(count);
    const BoxTree tree(balls.boxes);
    for (std::uint64_t query = 0; query < 200; ++query) {
      RandomStream random(9, 0, query);
      const float x = random.next_float(), y = random.next_float();
      const Vec3 point(x, y, 0.05F);
      std::vector<std::uint32_t> found, expected;
      tree.visit_point(point, [&](std::uint32_t leaf) { found.push_back(leaf); });
      for (std::uint32_t leaf = 0; leaf < balls.boxes.size(); ++leaf) {
        const Box& box = balls.boxes[leaf];
        if (glm::all(glm::lessThanEqual(box.low, point)) && glm::all(glm::lessThanEqual(point, box.high)))
          expected.push_back(leaf);
      }
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, AnEmptyTreeHoldsNothing) {
  const BoxTree tree{std::vector<Box>{}};
  EXPECT_TRUE(tree.empty());
  tree.visit_point({0, 0, 0}, [](std::uint32_t) { FAIL(); });
  tree.visit_nearest(
      {0, 0, 0}, [] { return 1.0F; }, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace gibench::meshless
