/// Nodes of meshes that are finer than asked for, or in many pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/spaces/place_clusters.h"
#include "methods/spectral/node_making.h"
#include "methods/spectral/spectral.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace spectral;

/// The rectangle from a corner along two sides, its front where their cross product points, in `along` × `across` quads. `gap`:
/// share of each quad's sides that is left free around it, so that they are loose pieces.
void add_tiles(made::SceneBuilder& builder, const std::string& name, std::uint32_t material, const Vec3& corner, const Vec3& u,
               const Vec3& v, int along, int across, float gap = 0.0F) {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
  const auto at = [&](float x, float y) {
    return corner + u * (x / static_cast<float>(along)) + v * (y / static_cast<float>(across));
  };
  if (gap > 0.0F) {
    for (int i = 0; i < along; ++i)
      for (int j = 0; j < across; ++j) {
        const auto x = static_cast<float>(i), y = static_cast<float>(j), far = 1.0F - gap;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), {at(x + gap, y + gap), at(x + far, y + gap), at(x + far, y + far), at(x + gap, y + far)});
        faces.push_back({first, first + 1, first + 2, first + 3});
      }
  } else {
    for (int i = 0; i <= along; ++i)
      for (int j = 0; j <= across; ++j) vertices.push_back(at(static_cast<float>(i), static_cast<float>(j)));
    const auto number = [&](int i, int j) { return static_cast<std::uint32_t>(i * (across + 1) + j); };
    for (int i = 0; i < along; ++i)
      for (int j = 0; j < across; ++j) faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
  }
  builder.object(name, material, vertices, faces);
}

/// The inside of the unit cube, made smaller by `inset`, of `tiles` × `tiles` quads a wall.
void add_tiled_room(made::SceneBuilder& builder, std::uint32_t material, int tiles, float inset = 0.0F, float gap = 0.0F,
                    const Vec3& from = Vec3(0.0F)) {
  const float size = 1.0F - 2.0F * inset;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      Vec3 corner = from + Vec3(inset), u(0.0F), v(0.0F);
      if (high) corner[axis] += size;
      u[(axis + (high ? 2 : 1)) % 3] = size;
      v[(axis + (high ? 1 : 2)) % 3] = size;
      add_tiles(builder, "wall " + std::to_string(2 * axis + (high ? 1 : 0)) + " from " + std::to_string(from.x), material,
                corner, u, v, tiles, tiles, gap);
    }
}

const PointLight lamp{{0.35F, 0.7F, 0.4F}, Rgb(1.0F)};

/// A unit room: of six quads, or each wall of so many tiles; a lamp in it.
Scene lit_room(int tiles) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  if (tiles == 0) builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  else add_tiled_room(builder, white, tiles);
  builder.light(lamp);
  return builder.build("lit room");
}

/// The same room hung with loose tiles half a millimetre before its walls; gaps take up less than a hundredth.
Scene loose_room(int tiles) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  add_tiled_room(builder, white, tiles, 0.0005F, 0.002F);
  builder.light(lamp);
  return builder.build("loose room");
}

struct Answer {
  std::vector<Rgb> indirect;
  Counters prepared;
};

Answer answer_at(const Scene& scene, const std::vector<Vec3>& places, const SettingTexts& settings) {
  const World world(scene);
  Task task;
  const MethodEntry entry = spectral_entry();
  const std::unique_ptr<MethodSession> method = make_session(entry, Parameters(entry.schema, settings));
  EffectPlan plan;
  plan.simulated = {Effect::direct, Effect::diffuse_indirect, Effect::occlusion};
  const StageReport prepared = method->prepare(world, plan, task), lit = method->light(Lighting::of(world.scene()), task);
  EXPECT_TRUE(succeeded(prepared.termination)) << prepared.message;
  EXPECT_TRUE(succeeded(lit.termination)) << lit.message;
  std::vector<SurfaceSample> samples;
  RayStream rays = task.rays(world);
  for (const Vec3& toward : places) {
    const Vec3 from(0.5F), direction = glm::normalize(toward - from);
    samples.push_back(world.sample_of_hit(rays.closest_hit({from, 0.0F, direction}), direction));
  }
  Answer answer{std::vector<Rgb>(samples.size()), prepared.counters};
  method->shade({Quantity::irradiance, samples, {}}, {{}, answer.indirect, {}, {}, {}}, task);
  return answer;
}

constexpr int tiles_a_wall = 41;

/// Places on the walls of the unit room, in the middle of tiles.
std::vector<Vec3> places_on_walls() {
  std::vector<Vec3> places;
  RandomStream random(5, 6, 7);
  while (places.size() < 300) {
    Vec3 place(0.0F);
    for (int axis = 0; axis < 3; ++axis) place[axis] = (std::floor(tiles_a_wall * random.next_float()) + 0.5F) / tiles_a_wall;
    const int axis = static_cast<int>(places.size() % 3);
    place[axis] = random.next_float() < 0.5F ? 0.0F : 1.0F;
    places.push_back(place);
  }
  return places;
}

/// Root mean square of the difference, over that of the expected values.
double difference(const std::vector<Rgb>& made, const std::vector<Rgb>& expected) {
  double squares = 0.0, differences = 0.0;
  for (std::size_t i = 0; i < made.size(); ++i) {
    squares += std::pow(static_cast<double>(expected[i].g), 2.0);
    differences += std::pow(static_cast<double>(made[i].g - expected[i].g), 2.0);
  }
  return std::sqrt(differences / squares);
}

const SettingTexts thousand{{"vertices", "1000"}, {"basis_functions", "300"}, {"part_vertices", "250"}, {"rays", "512"}};

// Each answer has the noise of its own 512 rays: light of one radiance over most of the hemisphere, and what varies of it by less
// than its mean, σ < 1 / √512 = 4.4% unstratified, 6.2% of two such answers.
constexpr double noise_of_two = 0.062;

TEST(SpectralNodes, ClustersOfLooseTrianglesHaveTheirOwnPlacesAndAllOfThem) {
  std::vector<Place> places;
  RandomStream random(8, 9, 10);
  const auto vector = [&] { return Vec3(random.next_float(), random.next_float(), random.next_float()); };
  for (int i = 0; i < 4000; ++i) places.push_back({vector(), glm::normalize(vector() - Vec3(0.5F)), 1e-4F, 0});
  for (const std::size_t most : {700U, 2000U, 3200U}) {  // of the last most are single places beside pairs
    Task task;
    const std::vector<std::uint32_t> cluster = cluster_places(places, {most, 0.7F}, task);
    const std::size_t count = cluster_count(cluster);
    std::vector<std::size_t> members(count, 0);
    for (const std::uint32_t own : cluster) ++members[own];
    EXPECT_LE(count, most);
    EXPECT_EQ(std::count(members.begin(), members.end(), 0U), 0) << most;
  }
}

TEST(SpectralNodes, AFinelyTessellatedBoxAnswersAsTheCoarseOne) {
  const std::vector<Vec3> places = places_on_walls();
  const Answer coarse = answer_at(lit_room(0), places, thousand), fine = answer_at(lit_room(50), places, thousand);
  EXPECT_EQ(coarse.prepared["clusters"], 0U);
  EXPECT_GT(fine.prepared["vertices"], 15000U);
  EXPECT_GT(fine.prepared["clusters"], 500U);
  EXPECT_LT(fine.prepared["clusters"], 2000U);  // where it is bright half as many more, and those that sight parts
  EXPECT_LT(difference(fine.indirect, coarse.indirect), noise_of_two);
}

TEST(SpectralNodes, TenThousandLoosePiecesAnswerAsOne) {
  const std::vector<Vec3> places = places_on_walls();
  const Answer whole = answer_at(lit_room(0), places, thousand), loose = answer_at(loose_room(tiles_a_wall), places, thousand);
  EXPECT_LT(loose.prepared["parts"], 300U);
  EXPECT_LT(loose.prepared["clusters"], 2500U);
  EXPECT_LT(difference(loose.indirect, whole.indirect), noise_of_two);
}

/// Two rooms on one floor of loose tiles or of one fine sheet, parted by a wall of two millimetres; both are lit.
SpectralRoom parted_rooms(float gap) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.quad("ceiling", white, {{{0, 1, 0}, {2, 1, 0}, {2, 1, 1}, {0, 1, 1}}});
  builder.quad("back", white, {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}});
  add_tiles(builder, "floor", white, Vec3(0.0F), {0.0F, 0.0F, 1.0F}, {2.0F, 0.0F, 0.0F}, 41, 83, gap);
  builder.block("wall", white, {1.02F, -0.01F, -0.01F}, {1.022F, 1.01F, 1.01F});
  builder.light(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  builder.light(PointLight{{1.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  return SpectralRoom(builder.build("parted rooms"),
                      {{"vertices", "800"}, {"basis_functions", "40"}, {"rays", "16"}, {"compression_error", "0"}});
}

TEST(SpectralNodes, NeitherNodesNorFunctionsReachThroughAWall) {
  for (const float gap : {0.02F, 0.0F}) {
    const SpectralRoom room = parted_rooms(gap);
    ASSERT_TRUE(succeeded(room.made.termination)) << room.made.message;
    const Transfer& transfer = room.transfer();
    ASSERT_FALSE(transfer.nodes.are_vertices());
    // The tiles of the floor that the wall stands on count on either side.
    const auto side = [&](const Vec3& position) { return position.x < 1.0F ? -1 : position.x > 1.05F ? 1 : 0; };
    const auto is_floor = [&](std::uint32_t vertex) {
      return room.world.scene().objects[transfer.mesh->vertices()[vertex].object].name == "floor";
    };
    for (const SpectralBasis::Part& part : transfer.basis.parts()) {
      bool left = false, right = false;
      for (std::uint32_t slot = part.begin; slot < part.end; ++slot)
        for (const std::uint32_t vertex : transfer.nodes.vertices(transfer.node_of_slot[slot])) {
          if (!is_floor(vertex)) continue;
          const int where = side(transfer.mesh->vertices()[vertex].position);
          left = left || where < 0;
          right = right || where > 0;
        }
      EXPECT_FALSE(left && right) << "gap " << gap << ", part of " << part.end - part.begin << " nodes";
    }
  }
}

/// A flat square of fine quads, held in clusters.
struct FlatSquare {
  SpectralRoom room;
  FlatSquare() : room(scene(), {{"vertices", "400"}, {"basis_functions", "30"}, {"rays", "4"}, {"compression_error", "0"}}) {}
  static Scene scene() {
    made::SceneBuilder builder;
    add_tiles(builder, "floor", builder.diffuse("white", Rgb(0.5F)), Vec3(0.0F), {0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, 100,
              100);
    builder.light(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
    return builder.build("square");
  }
  std::map<std::uint32_t, float> weights(std::uint32_t vertex) const {
    std::map<std::uint32_t, float> found;
    room.transfer().weights.each(vertex, [&](std::uint32_t slot, float weight) { found[slot] += weight; });
    return found;
  }
};

TEST(SpectralNodes, WeightsAreSharesAndHoldLinearFunctions) {
  const FlatSquare square;
  const Transfer& transfer = square.room.transfer();
  ASSERT_FALSE(transfer.nodes.are_vertices());
  const float spacing = 1.0F / std::sqrt(static_cast<float>(transfer.nodes.size()));
  double squares = 0.0;
  std::size_t inside = 0;
  for (std::uint32_t vertex = 0; vertex < transfer.mesh->vertices().size(); ++vertex) {
    float sum = 0.0F;
    Vec3 mean(0.0F);
    for (const auto& [slot, weight] : square.weights(vertex)) {
      EXPECT_GE(weight, 0.0F);
      sum += weight;
      mean += weight * transfer.node_at(slot).position;
    }
    EXPECT_NEAR(sum, 1.0F, 1e-5F);
    const Vec3& at = transfer.mesh->vertices()[vertex].position;
    if (std::min({at.x, at.z, 1.0F - at.x, 1.0F - at.z}) < spacing) continue;
    squares += static_cast<double>(glm::dot(mean - at, mean - at));
    ++inside;
  }
  // One value per node, without interpolation, would be off by the spread of a cell: 0.41 of its side.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(inside)), 0.1 * static_cast<double>(spacing));
}

TEST(SpectralNodes, NoStepsAreSeenBetweenClusters) {
  const FlatSquare square;
  const Transfer& transfer = square.room.transfer();
  const float spacing = 1.0F / std::sqrt(static_cast<float>(transfer.nodes.size()));
  const auto mean_place = [&](std::uint32_t vertex) {
    Vec3 mean(0.0F);
    for (const auto& [slot, weight] : square.weights(vertex)) mean += weight * transfer.node_at(slot).position;
    return mean;
  };
  // Were each vertex to have its node's value, it would move by the distance of two nodes across the border of a cluster.
  for (const MeshTriangle& triangle : transfer.mesh->triangles())
    EXPECT_LT(glm::length(mean_place(triangle.corners[0]) - mean_place(triangle.corners[1])), 0.8F * spacing);
}

TEST(SpectralNodes, SpaceThatNoLightReachesTakesFewNodes) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  add_tiled_room(builder, white, 25);
  add_tiled_room(builder, white, 25, 0.0F, 0.0F, {2.0F, 0.0F, 0.0F});
  builder.light(lamp);
  const SpectralRoom room(builder.build("lit and dark room"),
                          {{"vertices", "800"}, {"basis_functions", "60"}, {"rays", "4"}, {"compression_error", "0"}});
  const Transfer& transfer = room.transfer();
  std::size_t lit = 0, dark = 0;
  for (std::uint32_t node = 0; node < transfer.nodes.size(); ++node) {
    const bool second_room = transfer.nodes[node].position.x > 1.5F;
    EXPECT_EQ(transfer.nodes[node].reached, !second_room);
    (second_room ? dark : lit) += 1;
  }
  EXPECT_GT(lit, 400U);
  EXPECT_LE(dark, 800U / 8U);
}

TEST(SpectralNodes, ThePresetPaperKeepsEveryVertexAndEveryPiece) {
  const Parameters parameters(settings_schema(), with_preset(presets(), "paper", {}));
  EXPECT_EQ(settings_from(parameters).nodes, NodeKind::vertices);
  SpectralRoom room(
      loose_room(12),
      {{"nodes", "vertices"}, {"vertices", "500"}, {"basis_functions", "100"}, {"rays", "4"}, {"compression_error", "0"}});
  EXPECT_TRUE(room.transfer().nodes.are_vertices());
  EXPECT_GE(room.transfer().basis.parts().size(), 12U * 12U * 6U);
}

}  // namespace
}  // namespace gibench::test
