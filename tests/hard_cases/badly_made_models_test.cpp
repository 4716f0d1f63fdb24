/// Models as they come, on every registered method with its default settings: turned inside out, two-sided all over, sealed away
/// from the light, with cracks, on a plane far larger than their room.
///
/// The rooms are closed, diffuse and of one albedo ρ. Of a lamp's power Φ, Φ ρ / (1 − ρ) arrives after one reflection or more, so
/// that the mean of the indirect irradiance over the lit area A is Φ ρ / ((1 − ρ) A), whatever the room's shape.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/effects/scene_effects.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "common/spaces/space_report.h"
#include "common/spaces/surface_domain.h"
#include "methods/registry.h"
#include "tests/support/box_of_quads.h"

namespace gibench {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr float albedo = 0.5F, intensity = 1.0F;  // of all surfaces; W/sr of the lamp
constexpr std::size_t count = 8192;

/// A model, what is lit of it, and a part of the warning that it draws from `gibench check`.
struct BadModel {
  std::string name;
  Scene scene;
  double lit_area = 0.0;  ///< m²; 0: no light reaches anything
  std::string domain, warning;
};

/// Boxes of one white material around a lamp.
class Boxes {
 public:
  Boxes() : white_(builder_.diffuse("white", Rgb(albedo))) {}

  /// Fronts inwards or outwards.
  Boxes& box(const std::string& name, const Vec3& low, const Vec3& high, bool inwards, bool two_sided = false) {
    test::add_box(builder_, name, white_, low, high, inwards, two_sided);
    return *this;
  }
  /// A unit room of tiles, `across` of them along an edge and each a piece of its own, with gaps of `gap` between them.
  Boxes& tiles(int across, float gap) {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> faces;
    const float size = 1.0F / static_cast<float>(across);
    for (unsigned wall = 0; wall < 6; ++wall)
      for (int i = 0; i < across * across; ++i) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (unsigned corner = 0; corner < 4; ++corner) {
          const bool right = corner == 1 || corner == 2, up = corner >= 2;
          const float u = size * static_cast<float>(i % across + (right ? 1 : 0)) + (right ? -0.5F : 0.5F) * gap,
                      v = size * static_cast<float>(i / across + (up ? 1 : 0)) + (up ? -0.5F : 0.5F) * gap;
          Vec3 point;
          const int axis = static_cast<int>(wall / 2);
          point[axis] = wall % 2 == 0 ? 0.0F : 1.0F, point[(axis + 1) % 3] = u, point[(axis + 2) % 3] = v;
          vertices.push_back(point);
        }
        // u × v points along the axis: inwards on the lower wall.
        if (wall % 2 == 0) faces.push_back({first, first + 1, first + 2, first + 3});
        else faces.push_back({first, first + 3, first + 2, first + 1});
      }
    builder_.object("tiles", white_, vertices, faces);
    return *this;
  }
  Boxes& plane(float height, float half) {
    builder_.quad("ground", white_,
                  {{{-half, height, -half}, {-half, height, half}, {half, height, half}, {half, height, -half}}});
    return *this;
  }
  Boxes& lamp(const Vec3& position) {
    builder_.light(PointLight{position, Rgb(intensity)});
    return *this;
  }
  Boxes& sun(float irradiance) {
    builder_.light(DirectionalLight{glm::normalize(Vec3(0.2F, -1.0F, 0.1F)), Rgb(irradiance)});
    return *this;
  }
  Boxes& camera(const Vec3& position, const Vec3& look_at) {
    builder_.camera({"main", position, look_at, {0, 1, 0}, 80.0F, 32, 32});
    return *this;
  }
  Scene build() const { return builder_.build("scene"); }

 private:
  made::SceneBuilder builder_;
  std::uint32_t white_;
};

constexpr Vec3 lamp{0.35F, 0.8F, 0.4F};

/// A unit room with a cupboard that floats in it, within a shell.
Boxes hollow_walls(bool inside_out, bool two_sided) {
  Boxes boxes;
  boxes.box("room", Vec3(0.0F), Vec3(1.0F), !inside_out, two_sided)
      .box("shell", Vec3(-0.2F), Vec3(1.2F), inside_out, two_sided)
      .box("cupboard", {0.5F, 0.1F, 0.5F}, {0.8F, 0.5F, 0.8F}, inside_out, two_sided);
  return boxes;
}
constexpr double hollow_lit = 6.0 + 2.0 * (0.3 * 0.4 + 0.3 * 0.4 + 0.3 * 0.3);

std::vector<BadModel> made_models() {
  std::vector<BadModel> models;
  models.push_back(
      {"TwoSidedAllOver", hollow_walls(false, true).lamp(lamp).build(), hollow_lit, "all", "two-sided for nothing?"});
  models.push_back(
      {"InsideOutAndTwoSided", hollow_walls(true, true).lamp(lamp).build(), hollow_lit, "all", "inside out? Of the light"});
  models.push_back({"InsideOut", hollow_walls(true, false).lamp(lamp).build(), 0.0, "all", "inside out, or two-sided?"});
  models.push_back(
      {"SealedFromTheLight", hollow_walls(false, false).lamp({0.65F, 0.3F, 0.65F}).build(), 0.0, "all", "no light reaches"});
  // A room whose walls miss one another by 0.1 mm, in a dark hall: less than a thousandth of its light leaves.
  models.push_back(
      {"Cracks", Boxes().tiles(1, 1e-4F).box("hall", Vec3(-1.0F), Vec3(2.0F), true).lamp(lamp).build(), 6.0, "all", ""});
  // A room of 94 m² on 50 000 m² in the sun.
  models.push_back({"LargePlane",
                    Boxes()
                        .plane(-0.2F, 112.0F)
                        .box("room", Vec3(0.0F), {5.0F, 3.0F, 4.0F}, true)
                        .box("shell", Vec3(-0.199F), {5.2F, 3.2F, 4.2F}, false)
                        .lamp({2.0F, 2.4F, 1.5F})
                        .sun(1.0F)
                        .camera({0.5F, 1.5F, 0.5F}, {3.0F, 1.2F, 2.5F})
                        .build(),
                    94.0, "seen", ""});
  return models;
}

const std::vector<BadModel>& all_models() {
  static const std::vector<BadModel> models = made_models();
  return models;
}

/// Four standard errors of the mean of 8192 values whose deviation is as large as their mean; their stratification makes it less.
constexpr double sampling = 0.045;

/// What a method misses by more than the 2% within which it has to answer, as measured.
struct KnownMiss {
  const char *method, *model;
  double share;
};
constexpr std::array known_misses{
    KnownMiss{"meshless", "LargePlane", 0.10},
};

double own_error(const MethodEntry& entry, const BadModel& model) {
  for (const KnownMiss& miss : known_misses)
    if (entry.name == miss.method && model.name == miss.model) return miss.share;
  return 0.02;
}

struct Means {
  double direct = 0.0, indirect = 0.0;
};

Means means_of(const MethodEntry& entry, const World& world, const std::vector<SurfaceSample>& samples) {
  const auto method = make_session(entry, Parameters(entry.schema, {}));
  const EffectPlan plan = plan_effects(analyse_effects(world, PlanLimits{}), effects_of(method->capabilities()));
  Task task({.seed = 7, .threads = 2, .cancel = {}, .on_progress = {}});
  const auto expect_success = [](const StageReport& report) {
    EXPECT_TRUE(succeeded(report.termination)) << to_string(report.termination) << ": " << report.message;
  };
  expect_success(method->prepare(world, plan, task));
  expect_success(method->light(Lighting::of(world.scene()), task));
  std::vector<Rgb> direct(samples.size()), indirect(samples.size());
  expect_success(method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task));
  Means means;
  for (std::size_t i = 0; i < samples.size(); ++i)
    means.direct += static_cast<double>(direct[i].r), means.indirect += static_cast<double>(indirect[i].r);
  means.direct /= static_cast<double>(samples.size()), means.indirect /= static_cast<double>(samples.size());
  return means;
}

using MethodAndModel = std::tuple<std::size_t, std::size_t>;

class BadlyMade : public testing::TestWithParam<MethodAndModel> {};

TEST_P(BadlyMade, IsAnsweredWhereTheLightIs) {
  const auto& [method, which] = GetParam();
  const BadModel& model = all_models()[which];
  const World world(model.scene, 2);
  DomainFacts facts;
  const auto samples = domain_samples(world, surface_domain_of(model.domain, model.scene, ""), count, 11, 2, &facts);
  ASSERT_EQ(samples.size(), count);
  const Means means = means_of(all_methods()[method], world, samples);
  if (model.lit_area == 0.0) {
    EXPECT_TRUE(facts.nothing_reached);
    EXPECT_THAT(facts.note(), HasSubstr("no light reaches"));
    EXPECT_EQ(means.direct, 0.0);
    EXPECT_EQ(means.indirect, 0.0);
    return;
  }
  const double power = 4.0 * pi_double * static_cast<double>(intensity), rho = static_cast<double>(albedo);
  EXPECT_NEAR(means.direct / (power / model.lit_area), 1.0, sampling);
  EXPECT_NEAR(means.indirect / (power * rho / ((1.0 - rho) * model.lit_area)), 1.0,
              sampling + own_error(all_methods()[method], model));
}

std::string name_of(const testing::TestParamInfo<MethodAndModel>& info) {
  return all_methods()[std::get<0>(info.param)].name + "_" + all_models()[std::get<1>(info.param)].name;
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, BadlyMade,
                         testing::Combine(testing::Range<std::size_t>(0, all_methods().size()),
                                          testing::Range<std::size_t>(0, all_models().size())),
                         name_of);

class BadlyMadeModel : public testing::TestWithParam<std::size_t> {};

TEST_P(BadlyMadeModel, DrawsItsWarning) {
  const BadModel& model = all_models()[GetParam()];
  const World world(model.scene, 2);
  Task task;
  const std::vector<std::string> warnings = report_spaces(world, task).warnings;
  if (model.warning.empty()) EXPECT_THAT(warnings, testing::IsEmpty());
  else EXPECT_THAT(warnings, Contains(HasSubstr(model.warning)));
}

std::string name_of_model(const testing::TestParamInfo<std::size_t>& info) { return all_models()[info.param].name; }

INSTANTIATE_TEST_SUITE_P(OfSpaces, BadlyMadeModel, testing::Range<std::size_t>(0, all_models().size()), name_of_model);

}  // namespace
}  // namespace gibench
