#include "common/reflectance/lobe_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/core/sampling.h"
#include "common/core/sobol.h"
#include "common/reflectance/bsdf.h"

namespace gibench::test {
namespace {

constexpr std::uint32_t directions = 1U << 14;

Material phong(float exponent) {
  Material material;
  material.bsdf = Bsdf::phong;
  material.diffuse = Rgb(0.3F);
  material.specular = {0.4F, 0.2F, 0.1F};
  material.exponent = exponent;
  return material;
}
Material ggx(float roughness) {
  Material material;
  material.bsdf = Bsdf::ggx;
  material.roughness = roughness;
  material.f0 = {0.9F, 0.6F, 0.3F};
  return material;
}
Material plastic() {
  Material material = ggx(0.5F);
  material.f0 = Rgb(0.04F);
  material.diffuse = {0.9F, 0.5F, 0.1F};
  return material;
}
Material mirror() {
  Material material;
  material.bsdf = Bsdf::mirror;
  material.reflectance = Rgb(0.8F);
  return material;
}

Vec3 direction(const Frame& frame, float angle, float azimuth) {
  return frame.to_world({std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)});
}

/// ∫ cos f(in) · Σ over the hemisphere of `weigh`, f the lobe or its sum of harmonics.
template <class Weigh>
Rgb integral(const RgbHarmonics& lobe, const Frame& frame, const Weigh& weigh) {
  RgbDouble sum;
  const SobolSequence random(99);
  for (std::uint32_t i = 0; i < directions; ++i) {
    const Vec3 in = frame.to_world(cosine_hemisphere(random.pair(i, 0).unit()));
    const Harmonics h = spherical_harmonics(in);
    Rgb value;
    for (std::size_t k = 0; k < harmonic_count; ++k) value += lobe[k] * h[k];
    sum += RgbDouble(value * weigh(in));
  }
  return Rgb(sum * (pi_double / directions));
}

TEST(SphericalHarmonics, AreOrthonormal) {
  std::array<std::array<double, harmonic_count>, harmonic_count> products{};
  constexpr int rings = 256, columns = 32;  // the error of the rule itself is 2e-4
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < columns; ++j) {
      const float z = (2.0F * (static_cast<float>(i) + 0.5F) / rings) - 1.0F,
                  azimuth = 2.0F * pi * static_cast<float>(j) / columns;
      const float radius = std::sqrt(1.0F - z * z);
      const Harmonics h = spherical_harmonics({radius * std::cos(azimuth), radius * std::sin(azimuth), z});
      for (std::size_t a = 0; a < harmonic_count; ++a)
        for (std::size_t b = 0; b < harmonic_count; ++b)
          products[a][b] += static_cast<double>(h[a] * h[b]) * 4.0 * pi_double / (rings * columns);
    }
  for (std::size_t a = 0; a < harmonic_count; ++a)
    for (std::size_t b = 0; b < harmonic_count; ++b) EXPECT_NEAR(products[a][b], a == b ? 1.0 : 0.0, 3e-3);
}

TEST(SphericalHarmonics, TurnWithTheirFrame) {
  RgbHarmonics local{};
  for (std::size_t k = 0; k < harmonic_count; ++k)
    local[k] = Rgb(0.1F * static_cast<float>(k + 1), 1.0F, k % 2 == 0 ? -1.0F : 0.5F);
  const Frame frame(glm::normalize(Vec3(0.3F, -0.8F, 0.5F)));
  const RgbHarmonics world = to_world(local, frame);
  for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, 0.6F, -0.8F), glm::normalize(Vec3(1, 2, 3))}) {
    const Harmonics there = spherical_harmonics(frame.to_world(d)), here = spherical_harmonics(d);
    Rgb a, b;
    for (std::size_t k = 0; k < harmonic_count; ++k) a += world[k] * there[k], b += local[k] * here[k];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-4F);
  }
}

TEST(LobeHarmonics, LightOfOneRadianceIsReflectedAsByTheLobe) {
  const Frame frame(glm::normalize(Vec3(0.2F, 0.9F, -0.4F)));
  for (const Material& material : {phong(2.0F), phong(50.0F), ggx(0.8F), ggx(0.3F), plastic(), mirror()}) {
    const SurfaceBsdf bsdf = SurfaceBsdf::specular_part(material);
    const LobeHarmonics lobe(material);
    for (const float angle : {0.0F, 0.5F, 1.2F}) {
      Rgb albedo;
      const SobolSequence random(7);
      for (std::uint32_t i = 0; i < directions; ++i)
        albedo +=
            bsdf.sample({std::sin(angle), 0.0F, std::cos(angle)}, random.pair(i, 1).unit().x, random.pair(i, 0).unit()).weight *
            (1.0F / directions);
      const Rgb fitted =
          integral(lobe.coefficients(frame.normal, direction(frame, angle, 1.1F)), frame, [](const Vec3&) { return 1.0F; });
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(fitted[c], albedo[c], 0.01F * albedo[c] + 1e-4F);
    }
  }
}

TEST(LobeHarmonics, BroadLobesAreMatchedByDirection) {
  const Frame frame(glm::normalize(Vec3(0.2F, 0.9F, -0.4F)));
  for (const Material& material : {phong(2.0F), phong(4.0F), ggx(0.9F)}) {
    const LobeHarmonics lobe(material);
    const SurfaceBsdf bsdf = SurfaceBsdf::specular_part(material);
    for (const float angle : {0.0F, 0.6F}) {
      const Vec3 out = direction(frame, angle, 2.0F);
      const RgbHarmonics fitted = lobe.coefficients(frame.normal, out);
      // Sky on one side alone, as seen from there.
      const auto sky = [&](const Vec3& in) { return glm::dot(in, frame.tangent) > 0.0F ? 1.0F : 0.0F; };
      const Rgb got = integral(fitted, frame, sky);
      RgbDouble expected;
      const SobolSequence random(99);
      for (std::uint32_t i = 0; i < directions; ++i) {
        const Vec3 in = cosine_hemisphere(random.pair(i, 0).unit());
        expected += RgbDouble(bsdf.evaluate(frame.to_local(out), in).value * sky(frame.to_world(in))) * (pi_double / directions);
      }
      EXPECT_NEAR(got.r, expected.r, 0.03 * expected.r + 0.005);
    }
  }
}

TEST(LobeHarmonics, NothingLeavesBelowTheHorizon) {
  const LobeHarmonics lobe(phong(5.0F));
  for (const Rgb& c : lobe.coefficients({0, 0, 1}, glm::normalize(Vec3(1, 0, -0.1F)))) EXPECT_TRUE(is_black(c));
}

}  // namespace
}  // namespace gibench::test
