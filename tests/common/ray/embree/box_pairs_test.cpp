#include "common/ray/embree/box_pairs.h"

#include <gtest/gtest.h>

#include "common/core/random.h"

namespace gibench {
namespace {

std::vector<Box> random_boxes(std::size_t count) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(9, 0, i);
    const Vec3 low(random.next_float(), random.next_float(), random.next_float());
    boxes.push_back({low, low + 0.1F * Vec3(random.next_float(), random.next_float(), random.next_float())});
  }
  return boxes;
}

bool touch(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z &&
         b.low.z <= a.high.z;
}

TEST(BoxPairs, AreThoseOfEveryPairLookedAt) {
  const std::vector<Box> boxes = random_boxes(3000);
  std::vector<IndexPair> expected;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (touch(boxes[i], boxes[j]) && (i + j) % 3 != 0) expected.push_back({i, j});
  const auto keep = [](std::uint32_t i, std::uint32_t j) { return (i + j) % 3 != 0; };
  for (const int threads : {1, 2, 0}) EXPECT_EQ(overlapping_boxes(boxes, threads, keep), expected);
  ASSERT_GT(expected.size(), 1000U);
}

TEST(BoxPairs, OfFewBoxes) {
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  EXPECT_TRUE(overlapping_boxes({}, 1, all).empty());
  const std::vector<Box> one(1), same(5);
  EXPECT_TRUE(overlapping_boxes(one, 1, all).empty());
  EXPECT_EQ(overlapping_boxes(same, 1, all).size(), 10U);
}

}  // namespace
}  // namespace gibench
