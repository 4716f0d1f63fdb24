/// K of glossy surfaces: lobes over directional bins against quadrature of the lobe itself.
#include "methods/antiradiance/glossy.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "common/core/sampling.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/antiradiance/antiradiance.h"
#include "methods/antiradiance/bin_transport.h"

namespace gibench::antiradiance {
namespace {

Material phong(float exponent) {
  Material material;
  material.name = "satin";
  material.bsdf = Bsdf::phong;
  material.diffuse = Rgb(0.0F);
  material.specular = Rgb(0.5F);
  material.exponent = exponent;
  return material;
}

/// A floor that reflects with a Phong lobe alone, and a diffuse wall at its edge under light that grazes the floor: the wall's
/// radiosity is that of one reflection, even all over.
Scene wall_over_glossy_floor(float exponent) {
  made::SceneBuilder builder;
  const std::uint32_t satin = builder.material(phong(exponent)), white = builder.diffuse("white", Rgb(0.8F));
  builder.quad("floor", satin, {{{-1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}}});
  builder.quad("wall", white, {{{-1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {-1.0F, 1.0F, 0.0F}}});
  builder.light(DirectionalLight{{0.0F, 0.0F, -1.0F}, Rgb(pi)});
  return builder.build("wall over a glossy floor");
}

/// ∫ f L cos over the wall, its radiance 0.8.
double exact_radiance(const Vec3& point, const Vec3& toward_viewer, float exponent) {
  constexpr int steps = 400;
  const SurfaceBsdf bsdf(phong(exponent));
  const Frame frame({0.0F, 1.0F, 0.0F});
  double sum = 0.0;
  for (int row = 0; row < steps; ++row)
    for (int column = 0; column < 2 * steps; ++column) {
      const Vec3 d =
          Vec3((static_cast<float>(column) + 0.5F) / steps - 1.0F, (static_cast<float>(row) + 0.5F) / steps, 0.0F) - point;
      const float squared = glm::dot(d, d), r = std::sqrt(squared);
      const float geometry = (d.y / r) * (-d.z / r) / squared / (steps * steps);
      sum += static_cast<double>(bsdf.evaluate(frame.to_local(toward_viewer), frame.to_local(d / r)).value.g * 0.8F * geometry);
    }
  return sum;
}

/// What the method answers of one bounce at points of the floor against the integral, as sums over the points.
double answer_over_exact(float exponent, const char* bins) {
  const World world(wall_over_glossy_floor(exponent));
  const MethodEntry entry = antiradiance_entry();
  const auto method = make_session(entry, Parameters(entry.schema, {{"elements", "1500"}, {"bins", bins}}));
  const EffectPlan plan = plan_effects(analyse_effects(world, PlanLimits{{}, 1, 0.0, {}}), effects_of(method->capabilities()));
  Task task;
  EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
  EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
  std::vector<SurfaceSample> samples;
  for (const SurfaceSample& sample : area_uniform_samples(world, 300, 3))
    if (sample.object == 0 && std::fabs(sample.position.x) < 0.7F && sample.position.z > 0.15F && sample.position.z < 0.8F)
      samples.push_back(sample);
  const std::vector<Vec3> toward_viewer(samples.size(), glm::normalize(Vec3(0.0F, 0.6F, 0.8F)));
  std::vector<Rgb> indirect(samples.size());
  EXPECT_TRUE(
      succeeded(method->shade({Quantity::radiance, samples, toward_viewer}, {{}, indirect, {}, {}, {}}, task).termination));
  double found = 0.0, exact = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    found += static_cast<double>(indirect[i].g);
    exact += exact_radiance(samples[i].position, toward_viewer[i], exponent);
  }
  return found / exact;
}

TEST(Glossy, FloorShowsAWallAsItsLobeDoes) {
  EXPECT_NEAR(answer_over_exact(5.0F, "12"), 1.0, 0.05);
  EXPECT_NEAR(answer_over_exact(20.0F, "16"), 1.0, 0.05);
}

TEST(Glossy, LobeOverBinsGivesBackItsAlbedo) {
  made::SceneBuilder builder;
  const std::uint32_t satin = builder.material(phong(10.0F));
  builder.quad("floor", satin, {{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}}});
  const DirectionBins bins(16);
  const Scene scene = builder.build("satin");
  const std::array<std::uint32_t, 1> materials{satin};
  const GlossyReflection glossy(scene, materials, bins);
  ASSERT_TRUE(glossy.is_glossy(0));
  const Vec3 normal = glm::normalize(Vec3(0.2F, 1.0F, -0.3F));
  const Frame frame(normal);
  std::vector<float> projected(bins.count());
  projected_bins(bins, normal, projected);
  const SurfaceBsdf bsdf(phong(10.0F));
  for (std::size_t in = 0; in < bins.count(); ++in) {
    if (projected[in] > 0.0F) continue;
    std::vector<float> arriving(4 * bins.count()), exitant(arriving);
    for (std::size_t c = 0; c < 3; ++c) arriving[4 * in + c] = 1.0F;
    glossy.reflect(0, normal, projected, arriving.data(), exitant.data());
    double given_back = 0.0, exact = 0.0;
    for (std::size_t out = 0; out < bins.count(); ++out)
      if (projected[out] > 0.0F) given_back += static_cast<double>(exitant[4 * out] * projected[out]);
    constexpr int strata = 64;
    for (int k = 0; k < strata * strata; ++k) {
      const Vec2 at{(static_cast<float>(k % strata) + 0.5F) / strata, (static_cast<float>(k / strata) + 0.5F) / strata};
      exact += static_cast<double>(pi * bsdf.evaluate(cosine_hemisphere(at), frame.to_local(-bins.direction(in))).value.g);
    }
    exact /= strata * strata;
    EXPECT_LE(given_back, 0.5 * 1.0001);
    // Bins at the horizon hold more of the lobe's cut-off edge than their middles tell.
    if (-glm::dot(normal, bins.direction(in)) > 0.3F) {
      EXPECT_NEAR(given_back, exact, 0.05 * exact) << in;
    }
  }
}

}  // namespace
}  // namespace gibench::antiradiance
