#include "common/core/sobol.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

namespace gibench {
namespace {

TEST(Sobol, ReversesBits) {
  EXPECT_EQ(reverse_bits(1U), 0x80000000U);
  EXPECT_EQ(reverse_bits(0x00000003U), 0xc0000000U);
  EXPECT_EQ(reverse_bits(reverse_bits(0x12345678U)), 0x12345678U);
}

TEST(Sobol, SecondDimensionMatchesItsDirectionNumbers) {
  // Joe and Kuo 2008, d = 2: degree 1, m1 = 1, so m_i = 2 m_(i-1) xor m_(i-1).
  std::array<std::uint32_t, 32> direction;
  std::uint32_t m = 1;
  for (unsigned i = 0; i < 32; ++i) {
    direction[i] = m << (31U - i);
    m ^= m << 1U;
  }
  for (std::uint32_t index = 0; index < 5000; index = index * 3 / 2 + 1) {
    std::uint32_t expected = 0;
    for (unsigned bit = 0; bit < 32; ++bit)
      if ((index >> bit) & 1U) expected ^= direction[bit];
    EXPECT_EQ(reverse_bits(sobol_second_reversed(index)), expected) << index;
  }
}

TEST(Sobol, AnOwenScrambleIsABijectionThatKeepsTheTree) {
  // Two numbers that agree in their leading bits agree in as many afterwards, and differ in the next one.
  for (std::uint32_t seed : {1U, 77U, 0xdeadbeefU})
    for (unsigned bit = 0; bit < 31; ++bit) {
      const std::uint32_t x = 0x9e3779b9U, y = x ^ (0x80000000U >> bit);
      const std::uint32_t sx = reverse_bits(owen_scramble_reversed(reverse_bits(x), seed));
      const std::uint32_t sy = reverse_bits(owen_scramble_reversed(reverse_bits(y), seed));
      const std::uint32_t difference = sx ^ sy;
      EXPECT_EQ(difference >> (31U - bit), 1U) << "bit " << bit;
    }
}

/// Whether the points [begin, begin + 2^k) have one in every elementary interval of area 2^-k.
bool is_net(const SobolSequence& sequence, std::uint32_t dimension, std::uint32_t begin, unsigned k) {
  for (unsigned x_bits = 0; x_bits <= k; ++x_bits) {
    std::set<std::uint64_t> cells;
    for (std::uint32_t i = 0; i < (1U << k); ++i) {
      const SobolPair p = sequence.pair(begin + i, dimension);
      const std::uint64_t x = std::uint64_t{p.x} >> (32U - x_bits), y = std::uint64_t{p.y} >> (32U - (k - x_bits));
      cells.insert((x << 32U) | y);
    }
    if (cells.size() != (1U << k)) return false;
  }
  return true;
}

TEST(Sobol, EveryAlignedRunIsANet) {
  for (std::uint64_t key : {1ULL, 2ULL, 0xabcdefULL})
    for (std::uint32_t dimension : {0U, 1U, 513U})
      for (unsigned k = 0; k <= 8; ++k)
        for (std::uint32_t run : {0U, 1U, 5U})
          EXPECT_TRUE(is_net(SobolSequence(key), dimension, run << k, k)) << key << ' ' << dimension << ' ' << k << ' ' << run;
}

/// Chi-square of points given by `draw` over 8 × 8 cells: 63 degrees of freedom.
double chi_square(int count, const std::function<Vec2(int)>& draw) {
  std::array<int, 64> cells{};
  for (int i = 0; i < count; ++i) {
    const Vec2 u = draw(i);
    ++cells[static_cast<std::size_t>(static_cast<int>(u.x * 8.0F) * 8 + static_cast<int>(u.y * 8.0F))];
  }
  double sum = 0.0;
  const double expected = count / 64.0;
  for (const int n : cells) sum += (n - expected) * (n - expected) / expected;
  return sum;
}

constexpr double chi_square_63_limit = 63.0 + 4.5 * 11.2;  // 4.5 standard deviations

TEST(Sobol, EveryPointIsUniformOverTheKeys) {
  for (std::uint32_t index : {0U, 1U, 2U, 100U, 65535U})
    for (std::uint32_t dimension : {0U, 3U}) {
      const auto draw = [&](int key) { return SobolSequence(static_cast<std::uint64_t>(key)).pair(index, dimension).unit(); };
      EXPECT_LT(chi_square(64000, draw), chi_square_63_limit) << index << ' ' << dimension;
    }
}

TEST(Sobol, ReplicatesAndDimensionsAreIndependent) {
  // Coordinates of the same index under two keys, or in two pairs, fill the square evenly.
  const auto two_keys = [](int i) {
    const auto key = static_cast<std::uint64_t>(2 * i);
    return Vec2(SobolSequence(key).pair(7, 0).unit().x, SobolSequence(key + 1).pair(7, 0).unit().x);
  };
  const auto two_pairs = [](int i) {
    const SobolSequence sequence(static_cast<std::uint64_t>(i));
    return Vec2(sequence.pair(7, 0).unit().x, sequence.pair(7, 1).unit().x);
  };
  const auto within_one = [](int i) {
    const SobolSequence sequence(99);
    return Vec2(sequence.pair(static_cast<std::uint32_t>(i), 0).unit().y,
                sequence.pair(static_cast<std::uint32_t>(i), 1).unit().y);
  };
  const auto independent = [](int i) { return SobolSequence(3).independent_pair(static_cast<std::uint32_t>(i), 4).unit(); };
  EXPECT_LT(chi_square(64000, two_keys), chi_square_63_limit);
  EXPECT_LT(chi_square(64000, two_pairs), chi_square_63_limit);
  EXPECT_LT(chi_square(64000, within_one), chi_square_63_limit);
  EXPECT_LT(chi_square(64000, independent), chi_square_63_limit);
}

TEST(Sobol, TheScatterOfReplicatesTellsTheError) {
  // The area of a quarter disc from 64 replicates of 128 points: the squared error over the variance that the
  // replicates show is one on average; and that variance is far below the 1/n of independent points.
  constexpr int replicates = 64, points = 128, trials = 300;
  const double truth = pi_double / 4.0;
  double scores = 0.0, variances = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    double sum = 0.0, squares = 0.0;
    for (int replicate = 0; replicate < replicates; ++replicate) {
      const SobolSequence sequence(mix_keys(static_cast<std::uint64_t>(trial), static_cast<std::uint64_t>(replicate)));
      int inside = 0;
      for (std::uint32_t i = 0; i < points; ++i) {
        const Vec2 u = sequence.pair(i, 0).unit();
        inside += glm::dot(u, u) < 1.0F ? 1 : 0;
      }
      const double mean = static_cast<double>(inside) / points;
      sum += mean, squares += mean * mean;
    }
    const double mean = sum / replicates;
    const double variance = (squares / replicates - mean * mean) / (replicates - 1);
    scores += (mean - truth) * (mean - truth) / variance;
    variances += variance;
  }
  EXPECT_NEAR(scores / trials, 63.0 / 61.0, 4.5 * std::sqrt(2.2 / trials));
  EXPECT_LT(variances / trials, 0.1 * truth * (1.0 - truth) / (replicates * points));
}

}  // namespace
}  // namespace gibench
