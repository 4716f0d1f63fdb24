#include "methods/pathtracer/pathtracer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>

#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/pathtracer/replicate_sums.h"

namespace gibench {
namespace {

using made::SceneBuilder;
using Settings = std::vector<std::pair<std::string, std::string>>;

struct Values {
  std::vector<Rgb> direct, indirect, direct_variance, indirect_variance, total_variance;
  StageReport report;
};

/// A path tracer that has seen a scene.
class Tracer {
 public:
  explicit Tracer(const Scene& scene, const Settings& settings = {}, std::optional<int> bounces = std::nullopt)
      : world_(scene, 1) {
    const MethodEntry entry = pathtracer_entry();
    method_ = make_session(entry, Parameters(entry.schema, settings));
    EffectPlan plan;
    plan.max_bounces = bounces;
    Task task;
    EXPECT_TRUE(succeeded(method_->prepare(world_, plan, task).termination));
    relight(Lighting::of(world_.scene()));
  }

  void relight(const Lighting& lighting) {
    Task task;
    EXPECT_TRUE(succeeded(method_->light(lighting, task).termination));
  }
  const World& world() const { return world_; }
  const MethodSession& method() const { return *method_; }

  Values ask(Quantity quantity, const std::vector<SurfaceSample>& samples, const std::vector<Vec3>& viewers = {},
             const TaskSettings& settings = {}) const {
    const std::size_t count = samples.size();
    Values values;
    values.direct.resize(count), values.indirect.resize(count);
    ShadeAnswer answer{values.direct, values.indirect, {}, {}, {}};
    if (method_->capabilities().variance) {
      values.direct_variance.resize(count), values.indirect_variance.resize(count), values.total_variance.resize(count);
      answer.direct_variance = values.direct_variance;
      answer.indirect_variance = values.indirect_variance;
      answer.total_variance = values.total_variance;
    }
    Task task(settings);
    values.report = method_->shade({quantity, samples, viewers}, answer, task);
    EXPECT_TRUE(succeeded(values.report.termination)) << values.report.message;
    return values;
  }
  Values irradiance(std::size_t count, std::uint64_t seed = 1, int threads = 1) const {
    TaskSettings settings;
    settings.seed = seed, settings.threads = threads;
    return ask(Quantity::irradiance, area_uniform_samples(world_, count, 7), {}, settings);
  }

 private:
  World world_;
  std::unique_ptr<MethodSession> method_;
};

/// A room of one colour whose every face emits: radiance is emission / (1 − albedo) everywhere.
Scene furnace(float albedo) {
  SceneBuilder builder;
  builder.room("room", builder.diffuse("wall", Rgb(albedo), Rgb(1.0F)), Vec3(0.0F), Vec3(1.0F, 2.0F, 1.5F));
  return builder.build("furnace");
}

/// A square of this material under a constant sky of radiance 1.
Scene plate(const Material& material) {
  SceneBuilder builder;
  builder.quad("plate", builder.material(material), {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
  builder.light(EnvironmentLight());
  return builder.build("plate");
}

Material mirror(float reflectance) {
  Material material;
  material.bsdf = Bsdf::mirror;
  material.reflectance = Rgb(reflectance);
  return material;
}

double mean(const std::vector<Rgb>& values) {
  double sum = 0.0;
  for (const Rgb& value : values) sum += static_cast<double>(value.g);
  return sum / static_cast<double>(values.size());
}

TEST(PathTracer, TheSameSeedGivesTheSameBitsForAnyThreads) {
  const Tracer tracer(made::box_scene(), {{"samples", "48"}});
  const Values one = tracer.irradiance(200, 3, 1), two = tracer.irradiance(200, 3, 2), other = tracer.irradiance(200, 4, 1);
  EXPECT_EQ(one.direct, two.direct);
  EXPECT_EQ(one.indirect, two.indirect);
  EXPECT_EQ(one.total_variance, two.total_variance);
  EXPECT_NE(one.indirect, other.indirect);
}

TEST(PathTracer, ManySamplesOfOneValueGiveTheSameBitsForAnyThreads) {
  const Tracer tracer(made::box_scene(), {{"samples", "10000"}});
  const Values one = tracer.irradiance(2, 3, 1), two = tracer.irradiance(2, 3, 2);
  EXPECT_EQ(one.direct, two.direct);
  EXPECT_EQ(one.indirect, two.indirect);
}

TEST(PathTracer, ContinuesASequenceWhereItStopped) {
  for (const char* replicates : {"1", "16"}) {
    const Tracer whole(made::box_scene(), {{"samples", "96"}, {"replicates", replicates}});
    const Tracer first(made::box_scene(), {{"samples", "40"}, {"replicates", replicates}});
    const Tracer rest(made::box_scene(), {{"samples", "56"}, {"first_sample", "40"}, {"replicates", replicates}});
    const Values all = whole.irradiance(50), a = first.irradiance(50), b = rest.irradiance(50);
    for (std::size_t i = 0; i < 50; ++i) {
      const Rgb joined = a.indirect[i] * (40.0F / 96.0F) + b.indirect[i] * (56.0F / 96.0F);
      EXPECT_NEAR(joined.g, all.indirect[i].g, 1e-5F * all.indirect[i].g);
    }
  }
}

TEST(PathTracer, JoinsThePathsOfAValueThatTakesSeveralBatches) {
  const Tracer whole(made::box_scene(), {{"samples", "5000"}});
  const Tracer first(made::box_scene(), {{"samples", "1500"}});
  const Tracer rest(made::box_scene(), {{"samples", "3500"}, {"first_sample", "1500"}});
  const Values all = whole.irradiance(3), a = first.irradiance(3), b = rest.irradiance(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Rgb joined = a.indirect[i] * 0.3F + b.indirect[i] * 0.7F;
    EXPECT_NEAR(joined.g, all.indirect[i].g, 1e-5F * all.indirect[i].g);
    EXPECT_GT(all.total_variance[i].g, 0.0F);
  }
}

TEST(PathTracer, ReportsAfterAMillionPathsHoweverManyAValueHas) {
  // Sums for each batch of all 4 · 10⁹ paths would take 2 GB before the first report.
  const Tracer tracer(plate(mirror(1.0F)), {{"samples", "4294967295"}});
  const SurfaceSample sample = tracer.world().sample_at(0, {0.3F, 0.3F}, {0, 0, 1});
  TaskSettings settings;
  settings.cancel = std::make_shared<std::atomic<bool>>(false);
  settings.on_progress = [&](const ProgressPoint&) { settings.cancel->store(true); };
  Task task(settings);
  std::vector<Rgb> direct(1);
  const StageReport report = tracer.method().shade({Quantity::accessibility, {&sample, 1}, {}}, {direct, {}, {}, {}, {}}, task);
  EXPECT_EQ(report.termination, Termination::cancelled);
  EXPECT_GT(task.counters()["occlusion_rays"], 0U);
  EXPECT_LE(task.counters()["occlusion_rays"], 1U << 20U);
}

TEST(PathTracer, TellsItsVariance) {
  // Over many seeds: the scatter of a value is the mean of the variances that it reported, for both parts and their sum.
  const Tracer tracer(made::box_scene(), {{"samples", "64"}, {"replicates", "16"}});
  constexpr std::size_t points = 20;
  constexpr int seeds = 100;
  std::array<double, 3> scatter{}, reported{};
  std::vector<std::array<double, 6>> sums(points);
  for (int seed = 0; seed < seeds; ++seed) {
    const Values values = tracer.irradiance(points, static_cast<std::uint64_t>(seed) + 10);
    for (std::size_t i = 0; i < points; ++i) {
      const double direct = values.direct[i].g, indirect = values.indirect[i].g;
      const std::array<double, 3> parts{direct, indirect, direct + indirect};
      for (std::size_t part = 0; part < 3; ++part) sums[i][part] += parts[part], sums[i][part + 3] += parts[part] * parts[part];
      reported[0] += static_cast<double>(values.direct_variance[i].g) / seeds;
      reported[1] += static_cast<double>(values.indirect_variance[i].g) / seeds;
      reported[2] += static_cast<double>(values.total_variance[i].g) / seeds;
    }
  }
  for (const auto& sum : sums)
    for (std::size_t part = 0; part < 3; ++part) scatter[part] += (sum[part + 3] - sum[part] * sum[part] / seeds) / (seeds - 1);
  for (std::size_t part = 0; part < 3; ++part) EXPECT_NEAR(reported[part] / scatter[part], 1.0, 0.2) << part;
}

TEST(PathTracer, KnowsVarianceOnlyFromTwoReplicatesOn) {
  EXPECT_TRUE(Tracer(furnace(0.5F)).method().capabilities().variance);
  EXPECT_FALSE(Tracer(furnace(0.5F), {{"replicates", "1"}}).method().capabilities().variance);
  EXPECT_FALSE(Tracer(furnace(0.5F), {{"samples", "1"}}).method().capabilities().variance);
}

/// Errors' intervals take the spread over points for that of the seed as well, which holds for noise that no two points share:
/// the mean over points then varies over seeds as the points by themselves do, over their number.
TEST(PathTracer, NoiseIsIndependentBetweenPoints) {
  constexpr std::size_t seeds = 200, points = 60;
  for (const char* replicates : {"1", "16"}) {
    const Tracer tracer(made::box_scene(), {{"samples", "16"}, {"replicates", replicates}});
    // Sums and sums of squares over seeds: of every point, and of the mean over points.
    std::vector<double> sums(points + 1), squares(points + 1);
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const Values values = tracer.irradiance(points, seed);
      double mean_over_points = 0.0;
      const auto add = [&](std::size_t place, double value) { sums[place] += value, squares[place] += value * value; };
      for (std::size_t i = 0; i < points; ++i) {
        const double value = double{values.direct[i].g} + double{values.indirect[i].g};
        add(i, value);
        mean_over_points += value / static_cast<double>(points);
      }
      add(points, mean_over_points);
    }
    const auto variance = [&](std::size_t place) {
      const auto count = static_cast<double>(seeds);
      return (squares[place] - sums[place] * sums[place] / count) / (count - 1.0);
    };
    double of_points = 0.0;
    for (std::size_t i = 0; i < points; ++i) of_points += variance(i) / static_cast<double>(points * points);
    // A variance from 200 values is known to √(2/199), a tenth.
    EXPECT_NEAR(variance(points) / of_points, 1.0, 4.0 * std::sqrt(2.0 / static_cast<double>(seeds - 1))) << replicates;
  }
}

TEST(PathTracer, NeitherRouletteNorLightSamplesMoveTheMean) {
  const float albedo = 0.9F;
  const double truth = pi_double / (1.0 - static_cast<double>(albedo));
  for (const Settings& settings : {Settings{{"roulette_start", "1"}, {"roulette_below", "1"}},
                                   Settings{{"roulette_below", "0.01"}}, Settings{{"light_samples", "4"}}}) {
    Settings all = settings;
    all.emplace_back("samples", "1024");
    const Values values = Tracer(furnace(albedo), all).irradiance(100);
    std::vector<Rgb> total;
    double variance = 0.0;
    for (std::size_t i = 0; i < values.direct.size(); ++i) {
      total.push_back(values.direct[i] + values.indirect[i]);
      variance += static_cast<double>(values.total_variance[i].g) / 1e4;
    }
    EXPECT_NEAR(mean(total), truth, 4.0 * std::sqrt(variance) + 1e-5 * truth) << settings.front().first;
    EXPECT_LT(std::sqrt(variance), 0.005 * truth);
  }
}

TEST(PathTracer, BoundsTheReflections) {
  // In a furnace N reflections add up to π (1 + ρ + … + ρ^N).
  double truth = 1.0, power = 1.0;
  for (int bounces = 0; bounces <= 3; ++bounces) {
    const Values values = Tracer(furnace(0.5F), {{"samples", "256"}}, bounces).irradiance(100);
    EXPECT_NEAR(mean(values.direct), pi_double, 1e-2);
    EXPECT_NEAR(mean(values.indirect), pi_double * (truth - 1.0), 1e-2);
    truth += power *= 0.5;
  }
}

TEST(PathTracer, GivesEachPartAlone) {
  const Tracer tracer(made::box_scene());
  const auto samples = area_uniform_samples(tracer.world(), 50, 7);
  const Values both = tracer.irradiance(50);
  std::vector<Rgb> direct(50), indirect(50);
  Task task;
  ASSERT_TRUE(succeeded(tracer.method().shade({Quantity::irradiance, samples, {}}, {direct, {}, {}, {}, {}}, task).termination));
  const std::uint64_t direct_rays = task.counters()["closest_hit_rays"];
  EXPECT_EQ(direct_rays, 50U * 64U) << "one ray a path";
  ASSERT_TRUE(
      succeeded(tracer.method().shade({Quantity::irradiance, samples, {}}, {{}, indirect, {}, {}, {}}, task).termination));
  EXPECT_EQ(direct, both.direct);
  EXPECT_EQ(indirect, both.indirect);
}

TEST(PathTracer, ASunTakesNothingFromTheSky) {
  // Where nothing is hidden, each of them alone is exact; so are the two together.
  Scene scene = plate(Material());
  scene.lights.emplace_back(DirectionalLight{glm::normalize(Vec3(1.0F, 0.0F, -2.0F)), Rgb(30.0F)});
  const Tracer tracer(scene, {{"samples", "16"}});
  const Values values = tracer.irradiance(20);
  const float truth = pi + 30.0F * 2.0F / std::sqrt(5.0F);
  for (const Rgb& value : values.direct) EXPECT_NEAR(value.g, truth, 1e-5F * truth);
}

TEST(PathTracer, AMirrorThatIsAskedShowsWhatItSees) {
  const Tracer tracer(plate(mirror(0.8F)), {{"samples", "16"}});
  const SurfaceSample sample = tracer.world().sample_at(0, {0.3F, 0.3F}, {0, 0, 1});
  const Values seen = tracer.ask(Quantity::radiance, {sample}, {glm::normalize(Vec3(1.0F, 0.0F, 0.5F))});
  EXPECT_FLOAT_EQ(seen.direct[0].g, 0.8F);
  EXPECT_EQ(seen.indirect[0].g, 0.0F);
  const Values sent = tracer.ask(Quantity::radiosity, {sample});
  EXPECT_NEAR(sent.direct[0].g, 0.8F * pi, 1e-4F);
}

TEST(PathTracer, RadiosityOfAGlossySurfaceIsItsAlbedoOverAllDirections) {
  // Under a sky of radiance 1. With n = 0 the lobe is ks/π within 90 degrees of the mirror direction, else 0: the
  // radiosity is π ks times the share of cosine-distributed pairs of directions that lie so.
  Material glossy;
  glossy.bsdf = Bsdf::phong;
  glossy.specular = Rgb(0.7F);
  glossy.exponent = 0.0F;
  Tracer tracer(plate(glossy), {{"samples", "65536"}});
  const SurfaceSample sample = tracer.world().sample_at(0, {0.3F, 0.3F}, {0, 0, 1});
  const Values values = tracer.ask(Quantity::radiosity, {sample});
  double truth = 0.0;
  constexpr int steps = 300;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < 60; ++k) {
        const double out = std::sqrt((i + 0.5) / steps), in = std::sqrt((j + 0.5) / steps), azimuth = pi_double * (k + 0.5) / 60;
        const double lobe = out * in + std::sqrt((1 - out * out) * (1 - in * in)) * std::cos(azimuth);
        if (lobe > 0.0) truth += 0.7 * pi_double / (steps * steps * 60.0);
      }
  EXPECT_NEAR(static_cast<double>(values.direct[0].g), truth, 5e-3 * truth);
}

TEST(PathTracer, AnUnlitSideAndAnUnlitViewAreBlack) {
  const Tracer tracer(furnace(0.5F), {{"samples", "16"}});
  const SurfaceSample back = tracer.world().sample_at(0, {0.3F, 0.3F}, -tracer.world().normal(0));
  ASSERT_FALSE(back.lit_side);
  for (const Quantity quantity : {Quantity::irradiance, Quantity::radiosity, Quantity::accessibility}) {
    const Values values = tracer.ask(quantity, {back});
    EXPECT_TRUE(is_black(values.direct[0]) && is_black(values.indirect[0]));
  }
  const SurfaceSample front = tracer.world().sample_at(0, {0.3F, 0.3F}, tracer.world().normal(0));
  EXPECT_TRUE(is_black(tracer.ask(Quantity::radiance, {front}, {-front.normal}).direct[0]));
  EXPECT_TRUE(is_black(tracer.ask(Quantity::radiance, {back}, {back.normal}).direct[0]));
}

TEST(PathTracer, AccessibilityIsTheShareOfOpenSky) {
  const Tracer open(plate(mirror(1.0F))), closed(furnace(0.5F));
  const SurfaceSample sample = open.world().sample_at(0, {0.3F, 0.3F}, {0, 0, 1});
  EXPECT_EQ(open.ask(Quantity::accessibility, {sample}).direct[0], Rgb(1.0F));
  for (const Rgb& value : closed.ask(Quantity::accessibility, area_uniform_samples(closed.world(), 50, 7)).direct)
    EXPECT_EQ(value, Rgb());
}

TEST(PathTracer, RelightsWithoutPreparingAgain) {
  Tracer tracer(made::box_scene());
  const Values before = tracer.irradiance(20);
  Lighting lighting = Lighting::of(tracer.world().scene());
  for (Rgb& emission : lighting.emission) emission *= 2.0F;
  tracer.relight(lighting);
  const Values after = tracer.irradiance(20);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(after.indirect[i].g, 2.0F * before.indirect[i].g, 1e-5F * after.indirect[i].g);
}

TEST(PathTracer, EndsInAClosedWorldOfPerfectMirrors) {
  SceneBuilder builder;
  builder.room("room", builder.material(mirror(1.0F)), Vec3(0.0F), Vec3(1.0F));
  builder.light(PointLight{Vec3(0.5F), Rgb(1.0F)});
  const Values values = Tracer(builder.build("mirrors"), {{"samples", "16"}}).irradiance(20);
  EXPECT_GT(mean(values.direct), 0.0);
  EXPECT_EQ(mean(values.indirect), 0.0) << "no light sample meets a mirror's one direction";
}

TEST(PathTracer, ADarkSceneIsBlackWithoutRays) {
  SceneBuilder builder;
  builder.room("room", builder.diffuse("wall", Rgb(0.5F)), Vec3(0.0F), Vec3(1.0F));
  const Values values = Tracer(builder.build("dark")).irradiance(5);
  EXPECT_EQ(mean(values.direct), 0.0);
  EXPECT_EQ(values.report.counters["closest_hit_rays"], 0U);
}

TEST(ReplicateSums, GiveMeansAndTheVarianceOfTheMean) {
  using pathtracer::ReplicateSum;
  const auto sum = [](double direct, double indirect, std::uint64_t paths) {
    return ReplicateSum{RgbDouble(direct * static_cast<double>(paths)), RgbDouble(indirect * static_cast<double>(paths)), paths};
  };
  const std::vector<ReplicateSum> sums{sum(1.0, 4.0, 8), sum(3.0, 2.0, 8), sum(5.0, 6.0, 8)};
  const auto value = pathtracer::estimate(sums);
  EXPECT_DOUBLE_EQ(value.direct.r, 3.0);
  EXPECT_DOUBLE_EQ(value.indirect.r, 4.0);
  EXPECT_NEAR(value.direct_variance.r, 4.0 / 3.0, 1e-12);
  EXPECT_NEAR(value.total_variance.r, 12.0 / 3.0, 1e-12);  // totals 5, 5, 11
  const auto one = pathtracer::estimate(std::vector<ReplicateSum>{sum(1.0, 4.0, 8), sum(0.0, 0.0, 0)});
  EXPECT_DOUBLE_EQ(one.direct.r, 1.0);
  EXPECT_DOUBLE_EQ(one.direct_variance.r, 0.0);
}

}  // namespace
}  // namespace gibench
