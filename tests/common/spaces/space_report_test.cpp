#include "common/spaces/space_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/scene/made_scenes.h"
#include "tests/support/box_of_quads.h"

namespace gibench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// In a white of its own.
void add_box(made::SceneBuilder& builder, const std::string& name, const Vec3& low, const Vec3& high, bool inwards,
             bool two_sided) {
  const std::uint32_t white = builder.diffuse("white of " + name, Rgb(0.5F));
  test::add_box(builder, name, white, low, high, inwards, two_sided);
}

SpaceReport report_of(const made::SceneBuilder& builder) {
  const World world(builder.build("scene"), 1);
  Task task;
  return report_spaces(world, task);
}

SpaceReport report_of_room(bool inwards, bool two_sided) {
  made::SceneBuilder builder;
  add_box(builder, "room", {0, 0, 0}, {1, 1, 1}, inwards, two_sided);
  builder.light(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  return report_of(builder);
}

TEST(SpaceReport, AWellMadeRoomIsLitAllOverAndDrawsNoWarning) {
  const SpaceReport report = report_of_room(true, false);
  EXPECT_NEAR(report.area, 6.0, 1e-4);
  EXPECT_NEAR(report.lit_fronts, 6.0, 1e-4);
  EXPECT_EQ(report.lit_backs + report.seen_fronts + report.seen_backs + report.sealed, 0.0);
  EXPECT_FALSE(report.nothing_reached);
  EXPECT_THAT(report.warnings, IsEmpty());
  ASSERT_EQ(report.objects.size(), 1U);
  EXPECT_NEAR(report.objects[0].front.power, 4.0 * pi_double / 0.5, 0.01 * 8.0 * pi_double);
  EXPECT_EQ(report.objects[0].back.power, 0.0);
}

TEST(SpaceReport, ATwoSidedRoomOfWhichOnlyFrontsAreLitIsAskedAbout) {
  const SpaceReport report = report_of_room(true, true);
  EXPECT_NEAR(report.area, 12.0, 1e-4);
  EXPECT_NEAR(report.sealed, 6.0, 1e-4);
  EXPECT_THAT(report.warnings,
              ElementsAre(AllOf(HasSubstr("two-sided for nothing?"), HasSubstr("\"room\" 100.0% meets fronts"))));
}

TEST(SpaceReport, ATwoSidedRoomThatShowsItsBacksIsAskedAbout) {
  const SpaceReport report = report_of_room(false, true);
  EXPECT_NEAR(report.lit_backs, 6.0, 1e-4);
  EXPECT_THAT(report.warnings, ElementsAre(AllOf(HasSubstr("inside out?"), HasSubstr("two-sided \"room\" 100.0% meets backs"))));
}

TEST(SpaceReport, AOneSidedRoomThatIsInsideOutIsNamed) {
  const SpaceReport report = report_of_room(false, false);
  EXPECT_TRUE(report.nothing_reached);
  EXPECT_NEAR(report.objects[0].back.lit_area, 6.0, 1e-4);
  EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("no light reaches"),
                                           AllOf(HasSubstr("inside out"), HasSubstr("\"room\" 100.0% meets black backs"))));
}

TEST(SpaceReport, WithoutLightThereIsOneWarning) {
  made::SceneBuilder builder;
  add_box(builder, "room", {0, 0, 0}, {1, 1, 1}, true, true);
  EXPECT_THAT(report_of(builder).warnings, ElementsAre(HasSubstr("no light reaches")));
}

TEST(SpaceReport, ASheetThatIsLitFromBothSidesDrawsNoWarning) {
  made::SceneBuilder builder;
  add_box(builder, "room", {0, 0, 0}, {1, 1, 1}, true, false);
  builder.quad("sheet", builder.diffuse("sheet", Rgb(0.5F)),
               {Vec3(0.3F, 0.2F, 0.2F), Vec3(0.3F, 0.8F, 0.2F), Vec3(0.3F, 0.8F, 0.8F), Vec3(0.3F, 0.2F, 0.8F)}, true);
  builder.light(PointLight{{0.6F, 0.5F, 0.5F}, Rgb(1.0F)});
  EXPECT_THAT(report_of(builder).warnings, IsEmpty());
}

/// Of one model file: its walls are well made, its vault is turned.
TEST(SpaceReport, PartsOfAModelThatShowTheirBacksAreNamed) {
  made::SceneBuilder builder;
  add_box(builder, "hall/walls", {0, 0, 0}, {1, 1, 1}, true, true);
  builder.quad("hall/vault", builder.diffuse("vault", Rgb(0.5F)),
               {Vec3(0.3F, 0.999F, 0.7F), Vec3(0.7F, 0.999F, 0.7F), Vec3(0.7F, 0.999F, 0.3F), Vec3(0.3F, 0.999F, 0.3F)}, true);
  builder.light(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  // A wall of 1 m² gets a sixth, the vault's 0.16 m² about a twenty-fifth of all.
  EXPECT_THAT(report_of(builder).warnings,
              ElementsAre(AllOf(HasSubstr("for nothing?"), HasSubstr("\"hall\""), HasSubstr("mostly backs of \"hall/vault\""))));
}

/// Twenty plates in the sun make one warning, not twenty.
TEST(SpaceReport, ManyObjectsMakeOneWarning) {
  made::SceneBuilder builder;
  for (int i = 0; i < 20; ++i) {
    const float x = static_cast<float>(i);
    const std::string name = "plate " + std::to_string(i);
    builder.quad(name, builder.diffuse(name, Rgb(0.5F)), {Vec3(x, 0, 0), Vec3(x, 0, 1), Vec3(x + 1, 0, 1), Vec3(x + 1, 0, 0)},
                 true);
  }
  builder.light(DirectionalLight{{0, -1, 0}, Rgb(1.0F)});
  EXPECT_THAT(report_of(builder).warnings, ElementsAre(AllOf(HasSubstr("for nothing?"), HasSubstr("and 15 more"))));
}

}  // namespace
}  // namespace gibench
