#include <gtest/gtest.h>

#include <cmath>

#include "common/core/random.h"
#include "common/core/sobol.h"
#include "common/lighting/environment_sampler.h"

namespace gibench {
namespace {

EnvironmentLight image_light(int width, int height, const std::vector<Rgb>& pixels, float rotation = 0.0F) {
  auto image = std::make_shared<EnvironmentImage>();
  image->width = width, image->height = height;
  image->pixels = pixels;
  EnvironmentLight light;
  light.image = image;
  light.rotate_y_degrees = rotation;
  return light;
}

EnvironmentLight random_light(float rotation) {
  RandomStream random(1, 2, 3);
  std::vector<Rgb> pixels;
  for (int i = 0; i < 16 * 8; ++i) pixels.emplace_back(i % 5 == 0 ? 0.0F : random.next_float(), random.next_float(), 0.5F);
  pixels[37] = Rgb(50.0F);
  return image_light(16, 8, pixels, rotation);
}

TEST(Environment, FirstRowIsUpAndTheMiddleLooksAlongMinusZ) {
  std::vector<Rgb> pixels(8 * 4);
  pixels[1] = Rgb(1.0F);          // top row
  pixels[1 * 8 + 4] = Rgb(2.0F);  // just right of the middle, upper half
  pixels[2 * 8 + 6] = Rgb(3.0F);  // three quarters: towards +x
  const EnvironmentSampler environment(image_light(8, 4, pixels));
  EXPECT_EQ(environment.radiance(glm::normalize(Vec3(0.05F, 0.3F, -1.0F))).r, 2.0F);
  EXPECT_EQ(environment.radiance(glm::normalize(Vec3(1.0F, -0.3F, 0.05F))).r, 3.0F);
  // Column 1 of 8 is at azimuths −135 to −90 degrees from −z: towards −x, behind.
  EXPECT_EQ(environment.radiance(glm::normalize(Vec3(-0.1F, 1.0F, 0.05F))).r, 1.0F);
}

TEST(Environment, TurnsAboutTheVerticalLikeAnObject) {
  std::vector<Rgb> pixels(8 * 4);
  pixels[1 * 8 + 4] = Rgb(2.0F);
  const EnvironmentSampler environment(image_light(8, 4, pixels, 90.0F));
  // A right-handed quarter turn about +y carries −z to −x, and +x to −z.
  EXPECT_EQ(environment.radiance(glm::normalize(Vec3(-1.0F, 0.3F, -0.05F))).r, 2.0F);
  EXPECT_EQ(environment.radiance(glm::normalize(Vec3(0.05F, 0.3F, -1.0F))).r, 0.0F);
}

TEST(Environment, SamplesSayTheDensityOfTheirDirection) {
  for (const float rotation : {0.0F, 33.0F, -120.0F}) {
    const EnvironmentSampler environment(random_light(rotation));
    const SobolSequence sequence(4);
    const Vec3 normal{0.0F, 1.0F, 0.0F};
    RgbDouble sum;
    double solid_angle = 0.0;
    constexpr std::uint32_t count = 1 << 14;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3 direction = environment.sample(normal, sequence.pair(i, 0).unit());
      const float pdf = environment.pdf(normal, direction);
      EXPECT_NEAR(glm::length(direction), 1.0F, 1e-5F);
      ASSERT_GT(pdf, 0.0F);
      sum += RgbDouble(environment.radiance(direction)) / static_cast<double>(pdf);
      solid_angle += 1.0 / static_cast<double>(pdf);
    }
    // Mean of all channels: sampled in proportion to it, its integral comes without noise.
    EXPECT_NEAR((sum.r + sum.g + sum.b) / 3.0 / count, environment.integral(), 2e-3 * environment.integral());
    EXPECT_NEAR(solid_angle / count, 4.0 * pi_double, 0.03 * 4.0 * pi_double);
  }
}

TEST(Environment, IntegralMatchesUniformDirections) {
  const EnvironmentSampler environment(random_light(10.0F));
  const SobolSequence sequence(6);
  double sum = 0.0;
  constexpr std::uint32_t count = 1 << 16;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec2 u = sequence.pair(i, 0).unit();
    const float y = 1.0F - 2.0F * u.x, radius = std::sqrt(std::max(0.0F, 1.0F - y * y)), angle = 2.0F * pi * u.y;
    const Rgb radiance = environment.radiance({radius * std::cos(angle), y, radius * std::sin(angle)});
    sum += static_cast<double>(radiance.r + radiance.g + radiance.b) / 3.0;
  }
  EXPECT_NEAR(4.0 * pi_double * sum / count, environment.integral(), 5e-3 * environment.integral());
}

TEST(Environment, AConstantOneIsSampledByTheCosine) {
  EnvironmentLight light;
  light.radiance = Rgb(3.0F);
  const EnvironmentSampler environment(light);
  const Vec3 normal = glm::normalize(Vec3(1.0F, 2.0F, -0.5F));
  const Vec3 direction = environment.sample(normal, {0.3F, 0.7F});
  EXPECT_NEAR(environment.pdf(normal, direction), glm::dot(normal, direction) / pi, 1e-5F);
  EXPECT_NEAR(environment.integral(), 12.0 * pi_double, 1e-5);
}

TEST(Environment, OneSmallSunIsFoundAtOnce) {
  std::vector<Rgb> pixels(2048 * 1024, Rgb(1e-6F));
  pixels[300 * 2048 + 1000] = Rgb(1e6F);
  const EnvironmentSampler environment(image_light(2048, 1024, pixels));
  const SobolSequence sequence(8);
  int found = 0;
  for (std::uint32_t i = 0; i < 100; ++i)
    found += environment.radiance(environment.sample({0.0F, 1.0F, 0.0F}, sequence.pair(i, 0).unit())).r > 1.0F ? 1 : 0;
  EXPECT_GE(found, 95);
}

}  // namespace
}  // namespace gibench
