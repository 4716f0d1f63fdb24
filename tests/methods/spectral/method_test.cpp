/// The whole method: what it says of its answers, its preset, and materials that change under it.
#include <gtest/gtest.h>

#include "common/core/sampling.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/spectral/spectral.h"

namespace gibench::test {
namespace {

/// One solved scene.
struct Solved {
  World world;
  Task task;
  std::unique_ptr<MethodSession> method;
  StageReport prepared, lit;

  Solved(Scene scene, const SettingTexts& settings,
         EffectSet simulated = {Effect::direct, Effect::diffuse_indirect, Effect::occlusion})
      : world(std::move(scene)) {
    const MethodEntry entry = spectral_entry();
    method = make_session(entry, Parameters(entry.schema, settings));
    EffectPlan plan;
    plan.simulated = simulated;
    prepared = method->prepare(world, plan, task);
    if (succeeded(prepared.termination)) lit = method->light(Lighting::of(world.scene()), task);
  }

  /// Indirect light at the samples; of radiance, seen aslant.
  std::vector<Rgb> indirect(const std::vector<SurfaceSample>& samples, Quantity quantity, StageReport& report) {
    std::vector<Vec3> toward_viewer;
    for (const SurfaceSample& sample : samples)
      if (quantity == Quantity::radiance) toward_viewer.push_back(Frame(sample.normal).to_world({0.6F, 0.0F, 0.8F}));
    std::vector<Rgb> values(samples.size());
    report = method->shade({quantity, samples, toward_viewer}, {{}, values, {}, {}, {}}, task);
    return values;
  }
};

const SettingTexts small{{"vertices", "400"}, {"part_vertices", "100"}, {"basis_functions", "60"}, {"rays", "64"}};

SettingTexts with(SettingTexts settings, const SettingTexts& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

TEST(SpectralMethod, CountsLightThatItClampsToZero) {
  // A narrow lamp over a dark floor rings in a basis of few functions, and a complete basis does not.
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.8F));
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}});
  builder.quad("wall", white, {{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}});
  builder.light(PointLight{{2.0F, 0.2F, 3.0F}, Rgb(1.0F)});
  const Scene scene = builder.build("floor and wall");
  const auto clamped = [&](const char* functions) {
    Solved solved(scene, {{"vertices", "600"}, {"basis_functions", functions}, {"rays", "64"}, {"direct", "basis"}});
    const std::vector<SurfaceSample> samples = area_uniform_samples(solved.world, 500, 3);
    std::vector<Rgb> direct(500), indirect(500);
    const StageReport report =
        solved.method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, solved.task);
    for (const Rgb& value : direct) EXPECT_GE(value.r, 0.0F);
    return report.counters["clamped_samples"];
  };
  EXPECT_GT(clamped("12"), 20U);
  EXPECT_LT(clamped("65528"), 5U);
}

TEST(SpectralMethod, CountsTrianglesThatOtherSurfacesCut) {
  const auto counts_with = [](bool sheet) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
    builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
    if (sheet) builder.quad("sheet", white, {{{0, 0.47F, 0}, {0, 0.47F, 1}, {1, 0.47F, 1}, {1, 0.47F, 0}}});
    builder.light(PointLight{{0.5F, 0.8F, 0.5F}, Rgb(1.0F)});
    Solved solved(builder.build("parted room"), small);
    StageReport report;
    solved.indirect(area_uniform_samples(solved.world, 500, 3), Quantity::irradiance, report);
    return std::pair{solved.prepared.counters["cut_triangles"], report.counters["cut_samples"]};
  };
  const auto [no_triangles, no_samples] = counts_with(false);
  EXPECT_EQ(no_triangles, 0U);
  EXPECT_EQ(no_samples, 0U);
  const auto [triangles, samples] = counts_with(true);
  EXPECT_GT(triangles, 20U);
  EXPECT_GT(samples, 10U);
}

TEST(SpectralMethod, ThePapersOwnAlgorithmAgreesInAFurnace) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("glowing", Rgb(0.5F), Rgb(1.0F)), Vec3(0.0F), Vec3(1.0F));
  // The text's algorithm; of its sizes the mesh and the rays are smaller here.
  Solved solved(builder.build("furnace"), with_preset(spectral_entry().presets, "paper",
                                                      {{"vertices", "600"},
                                                       {"part_vertices", "150"},
                                                       {"basis_functions", "100"},
                                                       {"rays", "256"},
                                                       {"direct_samples", "64"}}));
  ASSERT_TRUE(succeeded(solved.lit.termination)) << solved.lit.message;
  StageReport report;
  const std::vector<Rgb> values = solved.indirect(area_uniform_samples(solved.world, 200, 3), Quantity::irradiance, report);
  for (const Rgb& value : values) EXPECT_NEAR(value.r, pi * 0.5F / (1.0F - 0.5F), 0.02F * pi);
}

Material shiny(float specular, float exponent) {
  Material material;
  material.name = "block";
  material.bsdf = Bsdf::phong;
  material.diffuse = Rgb(0.2F);
  material.specular = Rgb(specular);
  material.exponent = exponent;
  return material;
}

Scene room_with(const Material& block) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F, 0.5F, 0.3F)), own = builder.material(block);
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.block("block", own, {0.3F, 0.1F, 0.3F}, {0.6F, 0.5F, 0.6F});
  builder.light(PointLight{{0.2F, 0.8F, 0.2F}, Rgb(1.0F)});
  return builder.build("room");
}

/// A BRDF that is switched on the way answers as one that was there from the start, in what its lobe reflects, too.
TEST(SpectralMethod, BrdfsThatSwitchOnTheWayReflectAsThoseFromTheStart) {
  const EffectSet glossy{Effect::direct, Effect::diffuse_indirect, Effect::glossy_final_bounce, Effect::occlusion};
  const SettingTexts exact = with(small, {{"compression_error", "0"}});
  Material plain;
  plain.name = "block";
  plain.diffuse = Rgb(0.2F);
  const Material wide = shiny(0.6F, 4.0F), narrow = shiny(0.3F, 30.0F);
  for (const auto& [before, after] : {std::pair{plain, wide}, {wide, narrow}, {narrow, plain}}) {
    Solved switched(room_with(before), exact, glossy), fresh(room_with(after), exact, glossy);
    const std::vector<SurfaceSample> samples = area_uniform_samples(switched.world, 300, 3);
    StageReport report;
    const std::vector<Rgb> first = switched.indirect(samples, Quantity::radiance, report);
    const World edited(room_with(after));
    report = switched.method->edit(MaterialEdit{"block", after}, edited, Lighting::of(edited.scene()), switched.task);
    ASSERT_TRUE(succeeded(report.termination)) << report.message;
    const std::vector<Rgb> then = switched.indirect(samples, Quantity::radiance, report);
    const std::vector<Rgb> wanted = fresh.indirect(samples, Quantity::radiance, report);
    double moved = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      // Rows of vertices with and without slices are summed in another order.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(then[i][c], wanted[i][c], 1e-5F * (wanted[i][c] + 0.1F));
      if (samples[i].object == 1) moved += static_cast<double>(std::fabs(first[i].r - then[i].r));
    }
    EXPECT_GT(moved, 0.1);
  }
}

}  // namespace
}  // namespace gibench::test
