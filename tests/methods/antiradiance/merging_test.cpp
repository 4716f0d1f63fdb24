/// Merged discs: what may share one, how many there are, and what they answer.
#include "methods/antiradiance/merging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/antiradiance/elements.h"
#include "solved_scene.h"

namespace gibench::antiradiance {
namespace {

/// Faces of one object.
struct Faces {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;

  /// A parallelogram in tiles, counter-clockwise from `corner` along `right`, then `up`; loose ones share no vertices.
  void tiles(const Vec3& corner, const Vec3& right, const Vec3& up, int columns, int rows, bool loose = false) {
    const auto at = [&](int i, int k) {
      return corner + right * (static_cast<float>(i) / static_cast<float>(columns)) +
             up * (static_cast<float>(k) / static_cast<float>(rows));
    };
    const auto base = static_cast<std::uint32_t>(vertices.size());
    if (loose) {
      for (int k = 0; k < rows; ++k)
        for (int i = 0; i < columns; ++i) {
          const auto first = static_cast<std::uint32_t>(vertices.size());
          for (const Vec3& p : {at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}) vertices.push_back(p);
          faces.push_back({first, first + 1, first + 2, first + 3});
        }
      return;
    }
    for (int k = 0; k <= rows; ++k)
      for (int i = 0; i <= columns; ++i) vertices.push_back(at(i, k));
    const auto number = [&](int i, int k) { return base + static_cast<std::uint32_t>(k * (columns + 1) + i); };
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < columns; ++i) faces.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)});
  }

  /// The inside of a box, `count` tiles along every edge.
  void room(const Vec3& low, const Vec3& high, int count, bool loose = false) {
    const Vec3 x(high.x - low.x, 0.0F, 0.0F), y(0.0F, high.y - low.y, 0.0F), z(0.0F, 0.0F, high.z - low.z);
    tiles(low, z, x, count, count, loose);
    tiles(high, -x, -z, count, count, loose);
    tiles(low, x, y, count, count, loose);
    tiles(high - y, -x, y, count, count, loose);
    tiles(low + z, -z, y, count, count, loose);
    tiles(high - y - z, z, y, count, count, loose);
  }
};

Task task_of_one() { return Task({.seed = 1, .threads = 2, .cancel = {}, .on_progress = {}}); }

/// A room with a block of its own in it, in so many tiles.
Scene tiled_room(int count, bool loose = false) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  Faces room;
  room.room(Vec3(0.0F), Vec3(1.0F), count, loose);
  builder.object("room", white, room.vertices, room.faces);
  builder.block("block", white, {0.3F, 0.0F, 0.3F}, {0.6F, 0.5F, 0.6F});
  builder.light(PointLight{{0.7F, 0.8F, 0.5F}, Rgb(1.0F)});
  return builder.build("tiled room");
}

/// W/m², over all that is not hidden (the block's foot and the floor below): all light is absorbed, so that a power of 4π W makes
/// an irradiance of 4π / (1 − ρ) over the area, of which 4π are direct.
constexpr double indirect_of_room = 4.0 * pi_double * 0.7 / 0.3 / (6.0 - 0.09 + 0.6 + 0.09);

double mean_of_room(Solved& solved) {
  std::vector<SurfaceSample> samples = solved.samples(8000);
  std::erase_if(samples, [](const SurfaceSample& sample) {
    const Vec3 d = sample.position - Vec3(0.45F, 0.0F, 0.45F);
    return d.y < 1e-4F && std::fabs(d.x) < 0.15F && std::fabs(d.z) < 0.15F;
  });
  return mean(solved.irradiance(samples));
}

TEST(Merging, LeavesAMeshOfFewVerticesAlone) {
  Solved solved(tiled_room(4), {{"mode", "radiosity"}, {"elements", "800"}}),
      unmerged(tiled_room(4), {{"mode", "radiosity"}, {"elements", "800"}, {"merge", "false"}});
  const auto samples = solved.samples(200);
  const auto a = solved.irradiance(samples), b = unmerged.irradiance(samples);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].g, b[i].g) << i;
}

/// Faces so long that cutting them makes more vertices than are merged elsewhere.
TEST(Merging, LeavesAMeshThatIsOnlyCutAlone) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  for (int i = 0; i < 30; ++i) {
    const float x = 0.1F * static_cast<float>(i);
    builder.block("bar " + std::to_string(i), white, {x, 0.0F, 0.0F}, {x + 0.02F, 0.02F, 10.0F});
  }
  builder.light(PointLight{{1.5F, 2.0F, 5.0F}, Rgb(1.0F)});
  const Scene scene = builder.build("bars");
  Solved solved(scene, {{"mode", "radiosity"}, {"elements", "800"}}),
      unmerged(scene, {{"mode", "radiosity"}, {"elements", "800"}, {"merge", "false"}});
  EXPECT_GT(unmerged.prepared.counters["elements"], 1600U);
  EXPECT_EQ(solved.prepared.counters["elements"], unmerged.prepared.counters["elements"]);
}

TEST(Merging, OfAFineBoxAnswersAsTheCoarseBoxDoes) {
  for (const char* mode : {"radiosity", "implicit", "antiradiance"}) {
    const Setting setting{{"mode", mode}, {"elements", "1000"}, {"bins", "8"}};
    Solved coarse(tiled_room(1), setting), fine(tiled_room(40), setting);
    const std::uint64_t elements = fine.prepared.counters["elements"];
    EXPECT_GE(elements, 500U) << mode;
    EXPECT_LE(elements, 2000U) << mode;
    // As the truth cases ask for.
    EXPECT_NEAR(mean_of_room(fine), indirect_of_room, 0.05 * indirect_of_room) << mode;
    EXPECT_NEAR(mean_of_room(fine), mean_of_room(coarse), 0.05 * indirect_of_room) << mode;
  }
}

TEST(Merging, MakesFewDiscsOfThousandsOfLoosePieces) {
  const Setting setting{{"mode", "radiosity"}, {"elements", "1000"}};
  Solved loose(tiled_room(36, true), setting);
  EXPECT_GE(loose.prepared.counters["elements"], 500U);
  EXPECT_LE(loose.prepared.counters["elements"], 2000U);
  EXPECT_NE(loose.prepared.message.find("vertices share"), std::string::npos) << loose.prepared.message;
  EXPECT_NEAR(mean_of_room(loose), indirect_of_room, 0.05 * indirect_of_room);
}

struct Merged {
  Merged(Scene scene, std::size_t wanted) : world(std::move(scene)), task(task_of_one()), mesh(world, {1e9, 40.0F, true}) {
    merging = merge_discs(world, mesh, wanted, true, task);
  }
  /// Whether an element has vertices of which this is true and others of which it is not.
  template <class Predicate>
  bool mixes(const Predicate& predicate) const {
    std::vector<bool> with(merging.elements), without(merging.elements);
    for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v)
      (predicate(mesh.vertices()[v]) ? with : without)[merging.of_vertex[v]] = true;
    for (std::size_t e = 0; e < merging.elements; ++e)
      if (with[e] && without[e]) return true;
    return false;
  }
  World world;
  Task task;
  SamplingMesh mesh;
  Merging merging;
};

/// Two rooms of one object, so little apart that a disc would span both.
Scene rooms_back_to_back(bool both_lit) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  Faces rooms;
  rooms.room(Vec3(0.0F), Vec3(1.0F), 30);
  rooms.room({1.01F, 0.0F, 0.0F}, {2.01F, 1.0F, 1.0F}, 30);
  builder.object("rooms", white, rooms.vertices, rooms.faces);
  builder.light(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  if (both_lit) builder.light(PointLight{{1.5F, 0.5F, 0.5F}, Rgb(0.5F)});
  return builder.build("rooms back to back");
}

TEST(Merging, NeverSpansTwoRoomsBackToBack) {
  for (const bool both_lit : {false, true}) {
    const Merged merged(rooms_back_to_back(both_lit), 300);
    EXPECT_FALSE(merged.mixes([](const MeshVertex& vertex) { return vertex.position.x < 1.005F; })) << both_lit;
    EXPECT_LE(merged.merging.elements, 600U);
  }
}

TEST(Merging, NeverSpansAPartition) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  Faces room;
  room.room(Vec3(0.0F), Vec3(1.0F), 31);
  builder.object("room", white, room.vertices, room.faces);
  builder.quad("partition", white, {{{0.5F, 0.0F, 0.0F}, {0.5F, 0.0F, 1.0F}, {0.5F, 1.0F, 1.0F}, {0.5F, 1.0F, 0.0F}}}, true);
  builder.light(PointLight{{0.2F, 0.5F, 0.5F}, Rgb(1.0F)});
  builder.light(PointLight{{0.8F, 0.5F, 0.5F}, Rgb(0.3F)});
  const Merged merged(builder.build("parted room"), 150);
  EXPECT_FALSE(merged.mixes([](const MeshVertex& vertex) { return vertex.position.x < 0.5F; }));
}

TEST(Merging, KeepsTheSidesOfASheetApart) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  Faces sheet;
  sheet.tiles(Vec3(0.0F), {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 30, 30);
  builder.object("sheet", white, sheet.vertices, sheet.faces, true);
  builder.light(PointLight{{0.5F, 0.5F, 1.0F}, Rgb(1.0F)});
  builder.light(PointLight{{0.5F, 0.5F, -1.0F}, Rgb(1.0F)});
  const Merged merged(builder.build("sheet"), 100);
  EXPECT_FALSE(merged.mixes([](const MeshVertex& vertex) { return vertex.front; }));
}

/// Neighbouring answers differ by no more than the light does over that distance: discs are not seen.
TEST(Merging, AnswersSmoothly) {
  Solved fine(tiled_room(60), {{"mode", "radiosity"}, {"elements", "400"}});
  std::vector<SurfaceSample> along;
  const auto all = fine.samples(4000);
  const auto floor_triangle = std::find_if(
      all.begin(), all.end(), [](const SurfaceSample& s) { return s.object == 0 && s.normal.y > 0.5F && s.position.x > 0.8F; });
  ASSERT_NE(floor_triangle, all.end());
  // Every triangle of the floor's row at z near 0.8, from wall to wall.
  for (const SurfaceSample& s : all)
    if (s.object == 0 && s.normal.y > 0.5F && std::fabs(s.position.z - 0.8F) < 0.03F) along.push_back(s);
  std::sort(along.begin(), along.end(),
            [](const SurfaceSample& a, const SurfaceSample& b) { return a.position.x < b.position.x; });
  ASSERT_GT(along.size(), 20U);
  const auto values = fine.irradiance(along);
  const double average = mean(values);
  // A disc is 0.13 m wide. Light falls from 1 to a half over half of the room: 1 a metre.
  for (std::size_t i = 1; i < along.size(); ++i) {
    const double apart = static_cast<double>(glm::length(along[i].position - along[i - 1].position));
    EXPECT_LT(std::fabs(static_cast<double>(values[i].g - values[i - 1].g)), (0.03 + 3.0 * apart) * average) << i;
  }
}

}  // namespace
}  // namespace gibench::antiradiance
