#include "common/core/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gibench {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Lanes, WorkLaneByLane) {
  const Lanes a{1, 4, 9, 16, 25, 36, 49, 64};
  const Lanes root = square_root(a);
  for (std::size_t i = 0; i < lane_count; ++i) EXPECT_FLOAT_EQ(root[i], static_cast<float>(i + 1));
  EXPECT_FLOAT_EQ(sum_of(a), 204.0F);
  EXPECT_EQ(lane_bits(a > 16.5F), 0xf0U);
  EXPECT_EQ(lane_bits(smaller(a, all_lanes(3.0F)) == larger(a, all_lanes(3.0F))), 0U);
}

TEST(Lanes, OfWhatCannotBeOrderedTheFirstStays) {
  for (const auto& [a, b] : {std::pair(nan, 1.0F), std::pair(1.0F, nan), std::pair(-0.0F, 0.0F), std::pair(0.0F, -0.0F)}) {
    const Lanes low = smaller(all_lanes(a), all_lanes(b)), high = larger(all_lanes(a), all_lanes(b));
    for (const float got : {low[0], high[7], smaller(a, b), larger(a, b)}) {
      EXPECT_EQ(std::isnan(got), std::isnan(a));
      EXPECT_EQ(std::signbit(got), std::signbit(a));
    }
  }
}

TEST(Lanes, SetsOfLanesAreNumberedAndPacked) {
  const IndexLanes numbers{10, 11, 12, 13, 14, 15, 16, 17};
  for (unsigned set = 0; set < 256; ++set) {
    const IndexLanes together = packed_lanes(numbers, set);
    std::size_t at = 0;
    LaneMask mask{};
    for (std::uint32_t lane = 0; lane < lane_count; ++lane)
      if ((set >> lane & 1U) != 0) {
        EXPECT_EQ(together[at++], 10 + lane);
        mask[lane] = -1;
      }
    EXPECT_EQ(lane_bits(mask), set);
  }
  for (std::size_t count = 0; count <= lane_count; ++count) EXPECT_EQ(lane_bits(first_lanes(count)), (1U << count) - 1U);
}

TEST(Lanes, AreReadFromAnyAddressAndFromShortNumbers) {
  const float floats[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const std::int16_t shorts[9] = {0, 1, -2, 3, -4, 5, -6, 7, -32768};
  const Lanes a = load_numbers(floats + 1), b = load_numbers(shorts + 1);
  for (std::size_t i = 0; i < lane_count; ++i) {
    EXPECT_EQ(a[i], floats[i + 1]);
    EXPECT_EQ(b[i], static_cast<float>(shorts[i + 1]));
  }
}

}  // namespace
}  // namespace gibench
