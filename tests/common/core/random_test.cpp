#include "common/core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace gibench {
namespace {

TEST(RandomStream, TheSameKeysGiveTheSameNumbers) {
  RandomStream a(1, 2, 3), b(1, 2, 3);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.next_bits(), b.next_bits());
}

TEST(RandomStream, EveryKeyMattersAndSoDoesTheirOrder) {
  const std::array<std::array<std::uint64_t, 3>, 7> keys{
      {{1, 2, 3}, {2, 1, 3}, {1, 3, 2}, {3, 2, 1}, {0, 2, 3}, {1, 0, 3}, {1, 2, 0}}};
  std::set<std::uint64_t> first;
  for (const auto& [seed, stage, index] : keys) first.insert(RandomStream(seed, stage, index).next_bits());
  EXPECT_EQ(first.size(), keys.size());
}

TEST(RandomStream, NumbersLieInTheUnitIntervalBelowOne) {
  EXPECT_EQ(to_unit_float(0), 0.0F);
  EXPECT_LT(to_unit_float(0xffffffffU), 1.0F);
  RandomStream stream(4, 5, 6);
  for (int i = 0; i < 10'000; ++i) {
    const float x = stream.next_float();
    const double y = stream.next_double();
    ASSERT_TRUE(x >= 0.0F && x < 1.0F && y >= 0.0 && y < 1.0);
  }
}

/// Pearson's chi-squared statistic of `counts` against equal shares.
double chi_squared(const std::vector<int>& counts) {
  double total = 0.0, sum = 0.0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/// 255 degrees of freedom: mean 255, standard deviation 22.6; bounds at five of them either way.
void expect_uniform(const std::vector<int>& counts) {
  ASSERT_EQ(counts.size(), 256U);
  EXPECT_GT(chi_squared(counts), 255.0 - 5.0 * 22.6);
  EXPECT_LT(chi_squared(counts), 255.0 + 5.0 * 22.6);
}

TEST(RandomStream, IsUniformWithinOneStream) {
  std::vector<int> counts(256);
  RandomStream stream(7, 8, 9);
  for (int i = 0; i < 100'000; ++i) ++counts[static_cast<std::size_t>(stream.next_float() * 256.0F)];
  expect_uniform(counts);
}

TEST(RandomStream, FirstNumbersOfNeighbouringStreamsAreUniformInPairs) {
  std::vector<int> by_index(256), by_seed(256), pairs(256);
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    ++by_index[static_cast<std::size_t>(RandomStream(1, 1, i).next_float() * 256.0F)];
    ++by_seed[static_cast<std::size_t>(RandomStream(i, 1, 1).next_float() * 256.0F)];
    const float x = RandomStream(1, 1, i).next_float(), y = RandomStream(1, 1, i + 1).next_float();
    ++pairs[static_cast<std::size_t>(x * 16.0F) * 16 + static_cast<std::size_t>(y * 16.0F)];
  }
  expect_uniform(by_index);
  expect_uniform(by_seed);
  expect_uniform(pairs);
}

}  // namespace
}  // namespace gibench
