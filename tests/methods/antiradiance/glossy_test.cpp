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
#include "methods/antiradiance/interreflection.h"

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

Material ggx(float roughness) {
  Material material;
  material.name = "metal";
  material.bsdf = Bsdf::ggx;
  material.roughness = roughness;
  material.f0 = {0.9F, 0.5F, 0.1F};
  return material;
}

/// A floor of one glossy material.
Scene floor_of(const Material& material) {
  made::SceneBuilder builder;
  const std::uint32_t index = builder.material(material);
  builder.quad("floor", index, {{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}}});
  return builder.build("floor of " + material.name);
}

/// Any lobe that the bins are held to be fine enough for.
TEST(Glossy, NoLobeGivesBackMoreThanItsAlbedo) {
  constexpr int bins_a_side = 12;
  const DirectionBins bins(bins_a_side);
  const Vec3 normal = glm::normalize(Vec3(0.2F, 1.0F, -0.3F));
  const Frame frame(normal);
  std::vector<float> projected(bins.count());
  projected_bins(bins, normal, projected);
  for (const float roughness : {0.26F, 0.4F, 0.7F, 1.0F}) {
    const Material metal = ggx(roughness);
    ASSERT_EQ(too_narrow_for_bins(metal, bins_a_side), "") << roughness;
    const Scene scene = floor_of(metal);
    const std::array<std::uint32_t, 1> materials{0};
    const GlossyReflection glossy(scene, materials, bins);
    const SurfaceBsdf bsdf(metal);
    for (std::size_t in = 0; in < bins.count(); ++in) {
      if (projected[in] > 0.0F) continue;
      std::vector<float> arriving(channels * bins.count()), exitant(arriving);
      for (std::size_t c = 0; c < 3; ++c) arriving[channels * in + c] = 1.0F;
      glossy.reflect(0, normal, projected, arriving.data(), 1.0F, exitant.data());
      // Sampled in proportion to the lobe, the albedo is the mean of the weights.
      const Vec3 from = frame.to_local(-bins.direction(in));
      constexpr int strata = 32;
      Rgb albedo;
      for (int k = 0; k < strata * strata; ++k)
        albedo +=
            bsdf.sample(from, 0.5F,
                        {(static_cast<float>(k % strata) + 0.5F) / strata, (static_cast<float>(k / strata) + 0.5F) / strata})
                .weight /
            static_cast<float>(strata * strata);
      for (int c = 0; c < 3; ++c) {
        double given_back = 0.0;
        for (std::size_t out = 0; out < bins.count(); ++out)
          if (projected[out] > 0.0F)
            given_back += static_cast<double>(exitant[channels * out + static_cast<std::size_t>(c)] * projected[out]);
        EXPECT_LE(given_back, static_cast<double>(albedo[c]) + 0.01) << roughness << ", bin " << in << ", channel " << c;
      }
    }
  }
}

/// What is reflected of the light that links bring is scaled, whatever lobe reflects it.
TEST(Glossy, LobesReflectWhatTheClosureLeaves) {
  Task task;
  const World world(wall_over_glossy_floor(5.0F));
  const Settings settings = settings_from(Parameters(settings_schema(), {{"elements", "300"}, {"bins", "8"}}));
  const Discretisation parts(world, settings, task);
  const Linking linking = make_linking(world, parts, settings, Visibility::antiradiance, {}, task);
  std::vector<std::uint32_t> materials;
  std::vector<Rgb> direct;
  for (const std::uint32_t element : parts.hierarchy.order()) {
    const std::uint32_t object = parts.elements.sheet(element) / 2;
    materials.push_back(world.scene().objects[object].material);
    direct.emplace_back(object == 1 ? 1.0F : 0.0F);
  }
  const GlossyReflection glossy(world.scene(), materials, *linking.bins);
  // Light of the wall that the floor throws back: by the floor alone, which is all lobe. Only the floor's closure differs.
  const auto thrown_back = [&](float closure) {
    Surfaces surfaces;
    for (const std::uint32_t material : materials) surfaces.albedo.push_back(world.scene().materials[material].diffuse);
    for (std::size_t leaf = 0; leaf < materials.size(); ++leaf)
      surfaces.closure.push_back(glossy.is_glossy(leaf) ? closure : 1.0F);
    surfaces.glossy = &glossy;
    surfaces.max_bounces = 2;
    const Interreflection solved = interreflect(parts, linking, settings, surfaces, direct, task);
    double sum = 0.0;
    for (std::size_t leaf = 0; leaf < materials.size(); ++leaf)
      if (!glossy.is_glossy(leaf)) sum += static_cast<double>(solved.irradiance[leaf].g);
    return sum;
  };
  // Beside it there is what bins smear from the wall onto itself.
  const double whole = thrown_back(1.0F), smeared = thrown_back(0.0F);
  EXPECT_LT(smeared, 0.1 * whole);
  EXPECT_NEAR(thrown_back(0.5F), 0.5 * (smeared + whole), 1e-3 * whole);
}

/// Light that falls on a floor that reflects with its lobe alone, and from there on a wall that is dark otherwise.
struct CausticWall {
  static constexpr float exponent = 8.0F;
  Vec3 travels = glm::normalize(Vec3(0.0F, -1.0F, -1.0F));
  World world{scene(travels)};

  static Scene scene(const Vec3& travels) {
    made::SceneBuilder builder;
    const std::uint32_t satin = builder.material(phong(exponent)), white = builder.diffuse("white", Rgb(0.8F));
    builder.quad("floor", satin, {{{-1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}}});
    builder.quad("wall", white, {{{-1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {-1.0F, 1.0F, 0.0F}}});
    builder.light(DirectionalLight{travels, Rgb(2.0F)});
    return builder.build("caustic on a wall");
  }

  /// ∫ f E cos cos / r² over the floor.
  double exact(const Vec3& point) const {
    constexpr int steps = 200;
    const SurfaceBsdf bsdf(phong(exponent));
    const Frame frame({0.0F, 1.0F, 0.0F});
    const Vec3 in = frame.to_local(-travels);
    double sum = 0.0;
    for (int row = 0; row < steps; ++row)
      for (int column = 0; column < 2 * steps; ++column) {
        const Vec3 from((static_cast<float>(column) + 0.5F) / steps - 1.0F, 0.0F, (static_cast<float>(row) + 0.5F) / steps);
        const Vec3 d = point - from;
        const float squared = glm::dot(d, d), r = std::sqrt(squared);
        const float geometry = (d.y / r) * (-d.z / r) / squared / (steps * steps);
        if (!(geometry > 0.0F)) continue;
        sum += static_cast<double>(bsdf.evaluate(frame.to_local(d / r), in).value.g * 2.0F * in.z * geometry);
      }
    return sum;
  }

  /// Indirect irradiance at points of the wall after one reflection, over the exact: sums over the points.
  double answer_over_exact(const PlanLimits& limits) {
    const MethodEntry entry = antiradiance_entry();
    const auto method = make_session(entry, Parameters(entry.schema, {{"elements", "1500"}}));
    const EffectPlan plan = plan_effects(analyse_effects(world, limits), effects_of(method->capabilities()));
    Task task;
    EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
    EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
    std::vector<SurfaceSample> samples;
    for (const SurfaceSample& sample : area_uniform_samples(world, 400, 3))
      if (sample.object == 1 && std::fabs(sample.position.x) < 0.8F && sample.position.y > 0.1F) samples.push_back(sample);
    std::vector<Rgb> indirect(samples.size());
    EXPECT_TRUE(succeeded(method->shade({Quantity::irradiance, samples, {}}, {{}, indirect, {}, {}, {}}, task).termination));
    double found = 0.0, wanted = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      found += static_cast<double>(indirect[i].g);
      wanted += exact(samples[i].position);
    }
    return found / wanted;
  }
};

/// C.G[LOB]: the first reflection of all is a glossy one.
TEST(Glossy, FloorThrowsDirectLightOnAWall) {
  EXPECT_NEAR(CausticWall().answer_over_exact(PlanLimits{{}, 1, 0.0, {}}), 1.0, 0.05);
}

TEST(Glossy, ChainsThatAreNotAllowedAreNotMade) {
  const EffectSet without_chains{Effect::direct, Effect::diffuse_indirect, Effect::glossy_final_bounce};
  // Not quite nothing: bins smear a little light from the wall onto itself.
  EXPECT_LT(CausticWall().answer_over_exact(PlanLimits{without_chains, 1, 0.0, {}}), 0.01);
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
    std::vector<float> arriving(channels * bins.count()), exitant(arriving);
    for (std::size_t c = 0; c < 3; ++c) arriving[channels * in + c] = 1.0F;
    glossy.reflect(0, normal, projected, arriving.data(), 1.0F, exitant.data());
    double given_back = 0.0, exact = 0.0;
    for (std::size_t out = 0; out < bins.count(); ++out)
      if (projected[out] > 0.0F) given_back += static_cast<double>(exitant[channels * out] * projected[out]);
    constexpr int strata = 64;
    for (int k = 0; k < strata * strata; ++k) {
      const Vec2 at{(static_cast<float>(k % strata) + 0.5F) / strata, (static_cast<float>(k / strata) + 0.5F) / strata};
      exact += static_cast<double>(pi * bsdf.evaluate(cosine_hemisphere(at), frame.to_local(-bins.direction(in))).value.g);
    }
    exact /= strata * strata;
    EXPECT_LE(given_back, 0.5 * 1.0001);
    // The lobe's albedo is a table of 32 intervals.
    EXPECT_NEAR(given_back, exact, 0.01 * 0.5) << in;
  }
}

}  // namespace
}  // namespace gibench::antiradiance
