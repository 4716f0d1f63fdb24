/// Directional bins: an even cover of the sphere, and masks that neither lose nor make light.
#include "methods/antiradiance/bins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "methods/antiradiance/bin_transport.h"
#include "tests/support/random_direction.h"

namespace gibench::antiradiance {
namespace {

Vec3 direction(std::uint64_t i) { return test::random_direction(1, i); }

TEST(DirectionBins, HaveOneSizeAndCoverTheSphere) {
  for (const int resolution : {4, 8, 12}) {
    const DirectionBins bins(resolution);
    ASSERT_EQ(bins.count(), static_cast<std::size_t>(resolution * resolution));
    std::vector<double> found(bins.count(), 0.0);
    constexpr std::uint64_t draws = 400000;
    for (std::uint64_t i = 0; i < draws; ++i) {
      const DirectionBins::Place place = bins.place(direction(i));
      for (std::size_t k = 0; k < 4; ++k) found[bins.bins_of(place.quad)[k]] += static_cast<double>(place.shares[k]);
    }
    // Bilinear shares spread each draw over less than four bins: the scatter is below that of counts.
    const double expected = static_cast<double>(draws) / static_cast<double>(bins.count());
    for (const double count : found) EXPECT_NEAR(count, expected, 5.0 * std::sqrt(expected) + 0.002 * expected);
  }
}

TEST(DirectionBins, AreNearTheirDirections) {
  const DirectionBins bins(12);
  const float widest = 4.0F * std::sqrt(bins.solid_angle());
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const Vec3 w = direction(i);
    const DirectionBins::Place place = bins.place(w);
    float sum = 0.0F;
    for (std::size_t k = 0; k < 4; ++k) {
      sum += place.shares[k];
      if (place.shares[k] < 0.01F) continue;
      EXPECT_GT(glm::dot(w, bins.direction(bins.bins_of(place.quad)[k])), std::cos(widest));
    }
    EXPECT_NEAR(sum, 1.0F, 1e-6F);
  }
}

TEST(DirectionMask, SumsToOneOnTheRightSide) {
  const DirectionBins bins(8);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Vec3 w = direction(i), normal = direction(i + 100000);
    const float sign = glm::dot(w, normal) > 0.0F ? 1.0F : -1.0F;
    const DirectionBins::Place place = bins.place(w);
    const DirectionMask mask = bins.mask(place, normal, sign);
    EXPECT_EQ(std::accumulate(mask.weights.begin(), mask.weights.end(), 0), 255);
    int wrong = 0;
    for (std::size_t k = 0; k < 4; ++k)
      if (mask.weights[k] > 0 && sign * glm::dot(normal, bins.direction(bins.bins_of(place.quad)[k])) <= 0.0F)
        wrong += mask.weights[k];
    // Light that all but grazes may find all four middles beyond the plane.
    if (std::fabs(glm::dot(w, normal)) < 4.0F * bins.least_cosine()) continue;
    EXPECT_EQ(wrong, 0);
  }
}

TEST(ProjectedBins, SumToPiOnEitherSide) {
  const DirectionBins bins(12);
  std::vector<float> projected(bins.count());
  for (std::uint64_t i = 0; i < 100; ++i) {
    projected_bins(bins, direction(i), projected);
    double front = 0.0, back = 0.0;
    for (const float size : projected) (size > 0.0F ? front : back) += static_cast<double>(size);
    EXPECT_NEAR(front, pi_double, 1e-4);
    EXPECT_NEAR(back, -pi_double, 1e-4);
  }
}

}  // namespace
}  // namespace gibench::antiradiance
