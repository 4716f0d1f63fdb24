#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "common/core/random.h"
#include "common/finite_elements/compact_order.h"
#include "common/finite_elements/morton.h"

namespace gibench {
namespace {

TEST(Morton, InterleavesBits) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto bits = mix_keys(3, i);
    const auto x = static_cast<std::uint32_t>(bits), y = static_cast<std::uint32_t>(bits >> 32);
    std::uint64_t expected = 0;
    for (unsigned bit = 0; bit < 32; ++bit)
      expected |= std::uint64_t{(x >> bit) & 1U} << (2 * bit + 1) | std::uint64_t{(y >> bit) & 1U} << (2 * bit);
    EXPECT_EQ(along_morton_curve(x, y), expected);
  }
}

TEST(CompactOrder, HalvesAcrossTheLongestSide) {
  std::vector<Vec3> places;
  for (std::uint64_t i = 0; i < 256; ++i) {
    RandomStream random(5, 1, i);
    const float x = 8.0F * random.next_float(), y = 2.0F * random.next_float();
    places.push_back({x, y, random.next_float()});
  }
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto position_of = [&](std::uint32_t i) { return places[i]; };
  put_neighbours_together(
      std::span(order), 0, position_of,
      [&](int axis, std::uint32_t a, std::uint32_t b) { return places[a][axis] < places[b][axis]; },
      [](std::size_t size, std::size_t) { return size > 64 ? size / 2 : 0; });
  EXPECT_EQ(longest_side(std::span<const std::uint32_t>(order), position_of), 0);
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i);
  float before = 0.0F;  // four runs along the long side, one behind the other
  for (std::size_t run = 0; run < 4; ++run) {
    float low = 8.0F, high = 0.0F;
    for (std::size_t i = 64 * run; i < 64 * (run + 1); ++i) {
      low = std::min(low, places[order[i]].x);
      high = std::max(high, places[order[i]].x);
    }
    EXPECT_LE(before, low);
    before = high;
  }
}

}  // namespace
}  // namespace gibench
