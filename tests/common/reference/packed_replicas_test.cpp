#include "common/reference/packed_replicas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/core/random.h"
#include "tests/common/reference/references.h"

namespace gibench {
namespace {

/// Values from 1e-6 to 1e3, each with replicates around it by a share of it.
Replicas noisy(std::size_t count, std::size_t size, double share) {
  Replicas replicas;
  for (std::size_t r = 0; r < count; ++r) {
    std::vector<Rgb>& replica = replicas.replicas.emplace_back();
    for (std::size_t i = 0; i < size; ++i) {
      RandomStream level(1, 2, i), random(3, r, i);
      const double value = std::pow(10.0, 9.0 * level.next_double() - 6.0);
      const auto draw = [&] { return static_cast<float>(value * (1.0 + share * (random.next_double() - 0.5))); };
      replica.emplace_back(draw(), draw(), draw());
    }
  }
  return replicas;
}

Replicas unpacked(const Replicas& replicas, Grain grain = Grain::fine) {
  return unpack_replicas(pack_replicas(replicas, grain), replicas.count(), replicas.size());
}

TEST(PackedReplicas, DifferByHalfAStepAtMost) {
  const Replicas replicas = noisy(8, 500, 0.3);
  const std::vector<Rgb> variance = replicas.variance_of_mean(), mean = replicas.mean();
  for (const auto& [grain, size] : {std::pair{Grain::fine, 1.0}, {Grain::coarse, 1.5}}) {
    const Replicas read = unpacked(replicas, grain);
    for (std::size_t r = 0; r < replicas.count(); ++r)
      for (std::size_t i = 0; i < replicas.size(); ++i)
        for (int c = 0; c < 3; ++c) {
          // A step is 2 g σ at most, and a float's rounding comes on top.
          const double most = size * std::sqrt(8.0 * variance[i][c]) + 1e-6 * mean[i][c];
          ASSERT_LE(std::abs(read.replicas[r][i][c] - replicas.replicas[r][i][c]), most);
        }
  }
}

/// The sum over values of (packed − exact)/step, uniform in [−1/2, 1/2) and independent: its standard deviation is √(n/12).
TEST(PackedReplicas, KeepNoBias) {
  const std::size_t count = 8, size = 4000;
  const Replicas replicas = noisy(count, size, 0.3), read = unpacked(replicas);
  const std::vector<Rgb> variance = replicas.variance_of_mean();
  double sum = 0.0, squares = 0.0;
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t i = 0; i < size; ++i) {
      const double difference =
          (static_cast<double>(read.replicas[r][i].g) - replicas.replicas[r][i].g) / std::sqrt(variance[i].g);
      sum += difference;
      squares += difference * difference;
    }
  EXPECT_LT(std::abs(sum), 4.0 * std::sqrt(squares));
  EXPECT_GT(squares, 0.0);
}

/// Where all replicates agree, rounding is that of a 16-bit float, and independent from replicate to replicate.
TEST(PackedReplicas, WhatHasNoNoiseIsNearlyExactAndUnbiased) {
  const std::size_t size = 2000;
  Replicas replicas = noisy(8, size, 0.0);
  const Replicas read = unpacked(replicas);
  double product = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const double exact = replicas.replicas[0][i].r;
    for (std::size_t r = 0; r < 8; ++r) ASSERT_LE(std::abs(read.replicas[r][i].r - exact), std::ldexp(exact, -11) * 1.001);
    const double of_a = (read.half(0)[i].r - exact) / exact, of_b = (read.half(1)[i].r - exact) / exact;
    product += of_a * of_b;
    squares += of_a * of_a * of_b * of_b;
  }
  EXPECT_LT(std::abs(product), 4.0 * std::sqrt(squares)) << "the squared error of an exact answer stays 0";
}

TEST(PackedReplicas, KeepBlack) {
  Replicas replicas = noisy(8, 3, 0.2);
  for (std::vector<Rgb>& replica : replicas.replicas) replica[1] = Rgb(0.0F);
  const Replicas read = unpacked(replicas);
  for (std::size_t r = 0; r < 8; ++r) EXPECT_EQ(read.replicas[r][1], Rgb(0.0F));
}

/// One of all replicates holds all the light: the furthest that one can lie from the mean.
TEST(PackedReplicas, HoldASingleSpikeOfTheMostReplicates) {
  Replicas replicas;
  replicas.replicas.assign(most_packed_replicas, {Rgb(0.0F)});
  replicas.replicas[5][0] = Rgb(1.0F);
  const Replicas read = unpacked(replicas);
  for (std::size_t r = 0; r < most_packed_replicas; ++r) EXPECT_NEAR(read.replicas[r][0].r, r == 5 ? 1.0F : 0.0F, 0.25F);
}

TEST(PackedReplicas, OfOtherCountsAreNone) {
  const std::string bytes = pack_replicas(noisy(8, 10, 0.1), Grain::fine);
  EXPECT_EQ(unpack_replicas(bytes, 8, 11).count(), 0U);
  EXPECT_EQ(unpack_replicas(bytes.substr(0, bytes.size() / 2), 8, 10).count(), 0U);
  EXPECT_EQ(unpack_replicas("no deflated bytes", 8, 10).count(), 0U);
}

TEST(PackedReplicas, TakeAFractionOfTheRoom) {
  const std::size_t count = 8, size = 5000;
  const std::size_t fine = pack_replicas(noisy(count, size, 0.1), Grain::fine).size();
  EXPECT_LT(fine, count * size * sizeof(Rgb) / 5);
  EXPECT_LT(pack_replicas(noisy(count, size, 0.1), Grain::coarse).size(), fine);
  EXPECT_EQ(unpacked(Replicas{}).count(), 0U);
}

}  // namespace
}  // namespace gibench
