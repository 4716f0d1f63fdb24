/// The Haar transform: orthonormal for any areas, the plain one where they are equal, exact there and back.
#include <gtest/gtest.h>

#include <cmath>

#include "common/core/random.h"
#include "methods/wavelet/haar_step.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace wavelet;

TEST(HaarStep, IsOrthonormalForAnyAreas) {
  RandomStream random(1, 2, 3);
  for (int trial = 0; trial < 100; ++trial) {
    std::array<double, child_count> areas{};
    for (double& area : areas) area = std::pow(random.next_double(), 4.0) * (random.next_float() < 0.2F ? 0.0 : 1.0);
    const HaarStep step(areas);
    for (std::size_t k = 0; k < child_count; ++k)
      for (std::size_t l = 0; l < child_count; ++l) {
        float product = 0.0F;
        for (std::size_t i = 0; i < child_count; ++i) product += step.row(k)[i] * step.row(l)[i];
        EXPECT_NEAR(product, k == l ? 1.0F : 0.0F, 1e-6F);
      }
    const double total = areas[0] + areas[1] + areas[2] + areas[3];
    for (std::size_t i = 0; i < child_count && total > 0.0; ++i)
      EXPECT_NEAR(static_cast<double>(step.row(0)[i]), std::sqrt(areas[i] / total), 1e-6);
  }
}

TEST(HaarStep, IsTheNonStandardOneOfEqualAreas) {
  const HaarStep step({2.0, 2.0, 2.0, 2.0});
  EXPECT_EQ(step.row(0), (Four{0.5F, 0.5F, 0.5F, 0.5F}));
  EXPECT_EQ(step.row(1), (Four{0.5F, -0.5F, -0.5F, 0.5F}));
  EXPECT_EQ(step.row(2), (Four{0.5F, 0.5F, -0.5F, -0.5F}));
  EXPECT_EQ(step.row(3), (Four{0.5F, -0.5F, 0.5F, -0.5F}));
}

TEST(WaveletTransform, IsExactThereAndBackAndKeepsTheNorm) {
  const World world(open_corner(), 1);
  Task task;
  const Elements elements(world, {0.02, false, 0}, task);
  RandomStream random(4, 5, 6);
  std::vector<float> means;
  double squares = 0.0;
  for (const std::uint32_t leaf : elements.leaves()) {
    means.push_back(random.next_float());
    squares += static_cast<double>(means.back() * means.back() * elements.nodes()[leaf].area);
  }
  const Coefficients<float> coefficients = coefficients_of<float>(elements, means);
  double norm = 0.0;
  for (const float c : coefficients) norm += static_cast<double>(c * c);
  EXPECT_NEAR(norm, squares, 1e-5 * squares);
  const std::vector<float> back = leaf_means_of<float>(elements, coefficients);
  for (std::size_t i = 0; i < means.size(); ++i) EXPECT_NEAR(back[i], means[i], 3e-6F);
}

}  // namespace
}  // namespace gibench::test
