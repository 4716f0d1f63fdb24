#include "common/spaces/side_light.h"

#include <gtest/gtest.h>

#include <string>

#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

using made::SceneBuilder;

constexpr float albedo = 0.5F;

struct Room {
  SceneBuilder builder;
  std::uint32_t white = builder.diffuse("white", Rgb(albedo));
};

Light lamp_at(const Vec3& position, float intensity = 1.0F) { return PointLight{position, Rgb(intensity)}; }

/// A room of 1 m in a shell of 5 m, all walls one-sided and facing inwards: between them it is dark.
Scene room_in_a_shell() {
  Room made;
  made.builder.room("room", made.white, {0, 0, 0}, {1, 1, 1}).room("shell", made.white, {-2, -2, -2}, {3, 3, 3});
  made.builder.light(lamp_at({0.5F, 0.5F, 0.5F}));
  return made.builder.build("room in a shell");
}

struct Sides {
  explicit Sides(Scene scene, int threads = 2, const SideLightOptions& options = {})
      : world(std::move(scene), 1), task(TaskSettings{1, threads, {}, {}}), light(world, task, options) {}

  /// The share of an object's area on this side, of cells for which it holds.
  template <class Holds>
  double share(const std::string& object, bool front, const Holds& holds) const {
    double all = 0.0, some = 0.0;
    const SideCells& cells = light.cells();
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      const std::uint32_t of = world.scene().triangle_object[cells.triangle(cell)];
      if (world.scene().objects[of].name != object || cells.front(cell) != front) continue;
      all += static_cast<double>(cells.area(cell));
      if (holds(cell)) some += static_cast<double>(cells.area(cell));
    }
    return all > 0.0 ? some / all : 0.0;
  }
  double reached(const std::string& object, bool front = true) const {
    return share(object, front, [&](std::uint32_t cell) { return light.is_cell_reached(cell); });
  }
  double seen(const std::string& object, bool front = true) const {
    return share(object, front, [&](std::uint32_t cell) { return light.is_cell_seen(cell); });
  }
  double mean_irradiance(const std::string& object, bool front = true) const {
    double all = 0.0, sum = 0.0;
    for (std::uint32_t t = 0; t < world.scene().triangles.size(); ++t) {
      if (world.scene().objects[world.scene().triangle_object[t]].name != object) continue;
      all += static_cast<double>(world.area(t));
      sum += static_cast<double>(world.area(t)) * static_cast<double>(light.irradiance(t, front));
    }
    return sum / all;
  }

  World world;
  Task task;
  SideLight light;
};

TEST(SideLight, ALitRoomHasTheMeanOfAnIntegratingEnclosure) {
  const Sides sides(room_in_a_shell());
  // All that is emitted, 4π I, arrives; of that the share `albedo` again, and so on: 4π I / (A (1 − ρ)). 16 384 cells with two
  // points and 24 rays each: less than a percent off.
  const double expected = 4.0 * pi_double / (6.0 * (1.0 - albedo));
  EXPECT_NEAR(sides.mean_irradiance("room"), expected, 0.01 * expected);
  EXPECT_GT(sides.light.mean(), expected);  // weighted with itself
  EXPECT_LT(sides.light.mean(), 2.0 * expected);
}

TEST(SideLight, WhatLiesBetweenARoomAndAShellIsSealed) {
  const Sides sides(room_in_a_shell());
  EXPECT_EQ(sides.reached("room"), 1.0);
  EXPECT_EQ(sides.reached("shell"), 0.0);
  EXPECT_FALSE(sides.light.nothing_reached());
  for (std::uint32_t t = 0; t < sides.world.scene().triangles.size(); ++t) EXPECT_FALSE(sides.light.is_reached(t, false));
}

TEST(SideLight, ACavityInABlockIsSealed) {
  Room made;
  made.builder.room("room", made.white, {0, 0, 0}, {1, 1, 1});
  made.builder.block("cupboard", made.white, {0.3F, 0.3F, 0.3F}, {0.5F, 0.6F, 0.5F});
  made.builder.room("inside", made.white, {0.32F, 0.32F, 0.32F}, {0.48F, 0.58F, 0.48F});
  made.builder.light(lamp_at({0.8F, 0.8F, 0.8F}));
  const Sides sides(made.builder.build("cupboard"));
  EXPECT_EQ(sides.reached("room"), 1.0);
  EXPECT_EQ(sides.reached("cupboard"), 1.0);
  EXPECT_EQ(sides.reached("inside"), 0.0);
}

/// A lamp behind a screen: most of the room has no straight light.
TEST(SideLight, LightThatIsReflectedReachesWhatTheLampDoesNot) {
  Room made;
  made.builder.room("room", made.white, {0, 0, 0}, {4, 1, 1});
  made.builder.quad("screen", made.white, {Vec3(1, 0, 0), Vec3(1, 0.8F, 0), Vec3(1, 0.8F, 1), Vec3(1, 0, 1)}, true);
  made.builder.light(lamp_at({0.5F, 0.4F, 0.5F}));
  const Sides sides(made.builder.build("screen"));
  // At the far end, where a few thousandths of the mean arrive, 24 rays find too little of it here and there.
  EXPECT_GE(sides.reached("room"), 0.95);
  EXPECT_EQ(sides.reached("screen", true), 1.0);
  EXPECT_EQ(sides.reached("screen", false), 1.0);
}

TEST(SideLight, BacksOfATwoSidedRoomAreSealed) {
  Room made;
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i) corners.push_back({(i & 1U) != 0 ? 1 : 0, (i & 2U) != 0 ? 1 : 0, (i & 4U) != 0 ? 1 : 0});
  made.builder.object("room", made.white, corners,
                      {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}, true);
  made.builder.light(lamp_at({0.5F, 0.5F, 0.5F}));
  const Sides sides(made.builder.build("two-sided"));
  EXPECT_EQ(sides.reached("room", true), 1.0);
  EXPECT_EQ(sides.reached("room", false), 0.0);
}

TEST(SideLight, InARoomThatIsInsideOutEveryFrontCountsAsReached) {
  Room made;
  made.builder.block("room", made.white, {0, 0, 0}, {1, 1, 1}).light(lamp_at({0.5F, 0.5F, 0.5F}));
  const Scene scene = made.builder.build("inside out");
  const Sides sides(scene);
  EXPECT_TRUE(sides.light.nothing_reached());
  EXPECT_EQ(sides.light.mean(), 0.0F);
  EXPECT_EQ(sides.reached("room", true), 1.0);
  EXPECT_FALSE(sides.light.is_reached(0, false));
  const Sides with_backs(scene, 2, {CellSides::all});
  EXPECT_TRUE(with_backs.light.nothing_reached());
  EXPECT_NEAR(with_backs.mean_irradiance("room", false), 4.0 * pi_double / 6.0, 0.01 * 4.0 * pi_double / 6.0);
  EXPECT_EQ(with_backs.mean_irradiance("room", true), 0.0);
}

TEST(SideLight, WithoutLightEverythingCountsAsReached) {
  Room made;
  made.builder.room("room", made.white, {0, 0, 0}, {1, 1, 1});
  const Sides sides(made.builder.build("dark"));
  EXPECT_TRUE(sides.light.nothing_reached());
  EXPECT_EQ(sides.reached("room"), 1.0);
}

TEST(SideLight, TrianglesWithoutAreaAreNotReached) {
  Room made;
  made.builder.quad("floor", made.white, {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 0, 0)});
  made.builder.quad("line", made.white, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)});
  made.builder.light(lamp_at({0.5F, 1, 0.5F}));
  const Sides sides(made.builder.build("line"));
  EXPECT_TRUE(sides.light.is_reached(0, true));
  EXPECT_FALSE(sides.light.is_reached(2, true));
  EXPECT_EQ(sides.light.irradiance(2, true), 0.0F);
}

/// Two triangles of 25 000 m² in the sun, the room's floor a little above them.
TEST(SideLight, OfALargePlaneOnlyWhatLiesInTheSunIsReached) {
  Room made;
  const float reach = 112.0F;
  made.builder.quad("ground", made.white,
                    {Vec3(-reach, 0, -reach), Vec3(-reach, 0, reach), Vec3(reach, 0, reach), Vec3(reach, 0, -reach)});
  made.builder.room("room", made.white, {-5, 0.1F, -5}, {5, 3, 5})
      .block("shell", made.white, {-5.2F, 0, -5.2F}, {5.2F, 3.2F, 5.2F});
  made.builder.light(DirectionalLight{{0, -1, 0}, Rgb(3.0F)}).light(lamp_at({0, 2, 0}, 10.0F));
  const Sides sides(made.builder.build("plane"));
  const auto at = [&](const Vec3& place) {
    const Hit hit = sides.world.rays().closest_hit({place - Vec3(sides.world.scene().origin), 0.0F, {0, -1, 0}});
    return sides.world.sample_of_hit(hit, {0, -1, 0});
  };
  EXPECT_TRUE(sides.light.is_reached(at({60, 0.05F, 0})));
  EXPECT_TRUE(sides.light.is_reached(at({-20, 0.05F, 30})));
  EXPECT_FALSE(sides.light.is_reached(at({0.3F, 0.05F, 0.2F})));
  EXPECT_EQ(sides.reached("room"), 1.0);
  EXPECT_TRUE(sides.light.is_reached(0, true));  // some part of it is
}

/// Five sides of a box without a bottom, fronts inwards or outwards.
void add_hood(Room& made, const std::string& name, const Vec3& low, const Vec3& high, bool inwards) {
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.push_back({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  std::vector<std::array<std::uint32_t, 4>> faces{{0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  if (inwards)
    for (auto& face : faces) std::swap(face[1], face[3]);
  made.builder.object(name, made.white, corners, faces);
}

/// The ground goes through below the walls of a lit room of 100 m²; outside nothing is lit.
TEST(SideLight, NoLightPassesUnderWallsThatStandOnALargePlane) {
  Room made;
  const float reach = 112.0F;
  made.builder.quad("ground", made.white,
                    {Vec3(-reach, 0, -reach), Vec3(-reach, 0, reach), Vec3(reach, 0, reach), Vec3(reach, 0, -reach)});
  add_hood(made, "room", {-5, 0, -5}, {5, 3, 5}, true);
  add_hood(made, "shell", {-5.2F, 0, -5.2F}, {5.2F, 3.2F, 5.2F}, false);
  made.builder.light(lamp_at({0, 2, 0}, 10.0F));
  const Sides sides(made.builder.build("plane"));
  EXPECT_EQ(sides.reached("room"), 1.0);
  EXPECT_EQ(sides.reached("shell"), 0.0);
  // The room's own floor, and cells that its edges cross: each of these is less than 3 m wide.
  const double ground = 4.0 * 112.0 * 112.0;
  EXPECT_GE(sides.reached("ground") * ground, 100.0);
  EXPECT_LE(sides.reached("ground") * ground, 16.0 * 16.0);
}

/// A cupboard without a bottom, on a floor that is one face with the floor around it.
TEST(SideLight, ACupboardThatStandsOnTheFloorIsSealed) {
  Room made;
  made.builder.room("room", made.white, {0, 0, 0}, {4, 3, 4});
  add_hood(made, "cupboard", {1, 0, 1}, {2, 2, 1.5F}, false);
  add_hood(made, "inside", {1.02F, 0, 1.02F}, {1.98F, 1.98F, 1.48F}, true);
  made.builder.light(lamp_at({3, 2.5F, 3}));
  const Sides sides(made.builder.build("cupboard"));
  // All but the floor below the cupboard, 0.5 m² of 80 m².
  EXPECT_GE(sides.reached("room"), 1.0 - 0.5 / 80.0);
  EXPECT_LT(sides.reached("room"), 1.0);
  EXPECT_EQ(sides.reached("cupboard"), 1.0);
  // But for corners of the floor's cells, cut off by a wall beyond their points.
  EXPECT_LE(sides.reached("inside"), 0.002);
}

/// A room and a chamber side by side, one wall between them with a slit of 1 mm right through it.
TEST(SideLight, ACrackDoesNotLightAChamber) {
  Room made;
  const auto add = [&](const std::string& name, float low, float high, float open) {
    const auto quad = [&](const std::array<Vec3, 4>& corners) { made.builder.quad(name, made.white, corners); };
    const float closed = open == low ? high : low;
    const auto wall = [&](float x, float bottom, float top) {
      if (x == low) quad({Vec3(x, bottom, 0), Vec3(x, top, 0), Vec3(x, top, 1), Vec3(x, bottom, 1)});
      else quad({Vec3(x, bottom, 0), Vec3(x, bottom, 1), Vec3(x, top, 1), Vec3(x, top, 0)});
    };
    wall(closed, 0, 1), wall(open, 0, 0.5F), wall(open, 0.501F, 1);
    quad({Vec3(low, 0, 0), Vec3(low, 0, 1), Vec3(high, 0, 1), Vec3(high, 0, 0)});
    quad({Vec3(low, 1, 0), Vec3(high, 1, 0), Vec3(high, 1, 1), Vec3(low, 1, 1)});
    quad({Vec3(low, 0, 0), Vec3(high, 0, 0), Vec3(high, 1, 0), Vec3(low, 1, 0)});
    quad({Vec3(low, 0, 1), Vec3(low, 1, 1), Vec3(high, 1, 1), Vec3(high, 0, 1)});
  };
  add("room", 0, 1, 1), add("chamber", 1, 2, 1);
  made.builder.light(lamp_at({0.5F, 0.4F, 0.5F}));
  const Sides sides(made.builder.build("crack"));
  EXPECT_EQ(sides.reached("room"), 1.0);
  // A thousandth of a square metre lets 1e-3 E pass; over 6 m² that reflect half it gives 3e-4 E. Single cells are given more:
  // about 40 of 8192 hold the streak that the lamp casts, and one in 24 rays meets these from 24 · 40 / 8192 = 12% of the cells
  // at most.
  EXPECT_LE(sides.reached("chamber"), 0.13);
}

TEST(SideLight, CamerasSeeTheirRoomAndNotTheNext) {
  Room made;
  made.builder.room("here", made.white, {0, 0, 0}, {1, 1, 1}).room("there", made.white, {2, 0, 0}, {3, 1, 1});
  made.builder.light(lamp_at({2.5F, 0.5F, 0.5F}));
  Camera camera;
  camera.position = {0.5F, 0.5F, 0.9F}, camera.look_at = {0.5F, 0.5F, 0}, camera.up = {0, 1, 0},
  camera.vertical_fov_degrees = 110.0F;
  made.builder.camera(camera);
  const Sides sides(made.builder.build("two rooms"));
  EXPECT_GE(sides.seen("here"), 0.99);  // in corners behind the camera 24 rays may miss what it sees
  EXPECT_EQ(sides.seen("there"), 0.0);
  EXPECT_EQ(sides.reached("here"), 0.0);
  EXPECT_EQ(sides.reached("there"), 1.0);
}

TEST(SideLight, ASkyReachesWhatIsOpenToIt) {
  Room made;
  made.builder.block("block", made.white, {0, 0, 0}, {1, 1, 1})
      .room("hollow", made.white, {0.2F, 0.2F, 0.2F}, {0.8F, 0.8F, 0.8F});
  made.builder.light(EnvironmentLight{Rgb(1.0F), nullptr, 0.0F});
  const Sides sides(made.builder.build("under the sky"));
  EXPECT_EQ(sides.reached("block"), 1.0);
  EXPECT_EQ(sides.reached("hollow"), 0.0);
  EXPECT_NEAR(sides.mean_irradiance("block"), pi_double, 1e-3);  // of each convex body, whatever it reflects
}

TEST(SideLight, TheSameForAnyNumberOfThreads) {
  const Sides one(room_in_a_shell(), 1), three(room_in_a_shell(), 3);
  ASSERT_EQ(one.light.cells().size(), three.light.cells().size());
  for (std::uint32_t cell = 0; cell < one.light.cells().size(); ++cell)
    ASSERT_EQ(one.light.cell_irradiance(cell), three.light.cell_irradiance(cell));
  EXPECT_EQ(one.light.mean(), three.light.mean());
}

TEST(SideLight, RaysStayWithinAFewMillions) {
  constexpr std::uint32_t side = 400;  // 320 000 triangles
  Room made;
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (std::uint32_t x = 0; x <= side; ++x)
    for (std::uint32_t z = 0; z <= side; ++z) vertices.push_back({static_cast<float>(x), 0.0F, static_cast<float>(z)});
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t z = 0; z < side; ++z) {
      const std::uint32_t first = x * (side + 1) + z;
      faces.push_back({first, first + 1, first + side + 2, first + side + 1});
    }
  made.builder.object("plain", made.white, vertices, faces);
  const Sides sides(made.builder.build("plain"));
  EXPECT_LE(sides.task.counters()["closest_hit_rays"], 4'000'000U);
  EXPECT_GE(sides.task.counters()["closest_hit_rays"], 2'000'000U);
}

}  // namespace
}  // namespace gibench
