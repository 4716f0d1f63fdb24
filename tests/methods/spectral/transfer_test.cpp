#include "methods/spectral/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "common/core/random.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace spectral;
using Chosen = std::vector<std::pair<std::string, std::string>>;

std::vector<Rgb4> random_light(std::uint32_t slots) {
  std::vector<Rgb4> light(slots);
  RandomStream random(4, 5, 6);
  for (Rgb4& value : light) value = Rgb(random.next_float(), random.next_float(), 2.0F * random.next_float());
  return light;
}

/// Irradiance at every slot by the weights of the rays alone.
std::vector<RgbDouble> gathered(SpectralRoom& room, const std::vector<Rgb4>& light) {
  const VertexRays rays = room.rays();
  TransferRows rows(room.transfer().basis, rays);
  RayStream stream = room.task.rays(room.world);
  std::vector<RgbDouble> result;
  std::vector<float> weights(room.slots());
  for (std::uint32_t slot = 0; slot < room.slots(); ++slot) {
    rows.nodal(room.transfer().node_of_slot[slot], stream, weights);
    RgbDouble& sum = result.emplace_back();
    for (std::uint32_t j = 0; j < weights.size(); ++j) sum += RgbDouble(Rgb(light[j])) * static_cast<double>(weights[j]);
  }
  return result;
}

std::vector<Rgb4> transferred(SpectralRoom& room, const std::vector<Rgb4>& light) {
  std::vector<Rgb4> projected(room.transfer().basis.columns()), result(room.slots());
  room.transfer().basis.project(light, projected, room.task);
  room.transfer().one_bounce.multiply(projected, result, room.task);
  return result;
}

TEST(SpectralTransfer, CompleteBasisEqualsNodalGatheringThroughTheSameRays) {
  for (const char* laplacian : {"cotan", "graph"}) {
    SpectralRoom room(closed_room(), {{"vertices", "500"},
                                      {"part_vertices", "150"},
                                      {"basis_functions", "65528"},
                                      {"rays", "512"},
                                      {"compression_error", "0"},
                                      {"laplacian", laplacian}});
    ASSERT_EQ(room.made.termination, Termination::done) << room.made.message;
    ASSERT_EQ(room.transfer().basis.columns(), room.slots());
    const std::vector<Rgb4> light = random_light(room.slots());
    const std::vector<RgbDouble> expected = gathered(room, light);
    const std::vector<Rgb4> answer = transferred(room, light);
    for (std::uint32_t slot = 0; slot < room.slots(); ++slot)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(Rgb(answer[slot])[c]), expected[slot][c], 1e-4 * expected[slot][c]);
  }
}

TEST(SpectralTransfer, ClosedFurnaceHasOneValueAtEveryVertex) {
  for (const char* laplacian : {"cotan", "graph"})
    for (const char* error : {"0", "0.01"}) {
      SpectralRoom room(closed_room(), {{"vertices", "1500"},
                                        {"part_vertices", "200"},
                                        {"basis_functions", "100"},
                                        {"rays", "256"},
                                        {"compression_error", error},
                                        {"laplacian", laplacian}});
      const std::vector<Rgb4> answer = transferred(room, std::vector<Rgb4>(room.slots(), Rgb(2.0F)));
      for (const Rgb4& value : answer) EXPECT_NEAR(value.r, 2.0F * pi, 0.01F * 2.0F * pi);
    }
}

TEST(SpectralTransfer, SmoothLightNeedsFewFunctions) {
  SpectralRoom room(closed_room(),
                    {{"vertices", "1500"}, {"basis_functions", "150"}, {"rays", "256"}, {"compression_error", "0"}});
  std::vector<Rgb4> light;
  for (const std::uint32_t node : room.transfer().node_of_slot) {
    const Vec3& p = room.transfer().nodes[node].position;
    light.emplace_back(Rgb(1.0F + p.x, 2.0F + std::sin(2.0F * p.y), 1.0F + p.z * p.z));
  }
  const std::vector<RgbDouble> expected = gathered(room, light);
  const std::vector<Rgb4> answer = transferred(room, light);
  // Worst beside the edges of parts, whose functions are flat there.
  double squares = 0.0, changed = 0.0;
  for (std::uint32_t slot = 0; slot < room.slots(); ++slot) {
    const double off = static_cast<double>(answer[slot].g) - expected[slot].g;
    changed += off * off;
    squares += expected[slot].g * expected[slot].g;
  }
  EXPECT_LT(std::sqrt(changed / squares), 0.01);
}

SpectralRoom compressed_room(const std::string& error, const std::string& rays) {
  return SpectralRoom(closed_room(),
                      {{"vertices", "1500"}, {"basis_functions", "200"}, {"rays", rays}, {"compression_error", error}});
}

/// Mean square of the deviation from the truth, over that of the truth.
double squared_error(const std::vector<Rgb4>& answer, const std::vector<Rgb4>& truth) {
  double errors = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    errors += std::pow(static_cast<double>(answer[i].r - truth[i].r), 2.0);
    squares += std::pow(static_cast<double>(truth[i].r), 2.0);
  }
  return errors / squares;
}

/// Light that falls off with the square of the distance to a lamp; lamps anywhere in the room, none of them those tried out.
std::vector<std::vector<Rgb4>> lamps(const SpectralRoom& room, std::size_t count) {
  std::vector<std::vector<Rgb4>> lights(count);
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(7, 8, i);
    const Vec3 place = Vec3(0.05F) + Vec3(0.9F, 1.4F, 1.9F) * Vec3(random.next_float(), random.next_float(), random.next_float());
    for (const std::uint32_t node : room.transfer().node_of_slot) {
      const Node& at = room.transfer().nodes[node];
      const Vec3 toward = place - at.position;
      const float squared = glm::dot(toward, toward) + 0.01F;
      lights[i].emplace_back(Rgb(std::max(0.0F, glm::dot(toward, at.normal)) / (squared * std::sqrt(squared))));
    }
  }
  return lights;
}

TEST(SpectralTransfer, CompressionAddsNoMoreErrorThanAskedForToLightThatWasNotTriedOut) {
  SpectralRoom truth = compressed_room("0", "16384"), exact = compressed_room("0", "256");
  const std::vector<std::vector<Rgb4>> lights = lamps(exact, 40);
  std::vector<std::vector<Rgb4>> expected;
  double of_rays = 0.0;
  for (const std::vector<Rgb4>& light : lights) {
    expected.push_back(transferred(truth, light));
    of_rays += squared_error(transferred(exact, light), expected.back()) / 40.0;
  }
  std::uint64_t before = exact.transfer().one_bounce.coefficients();
  for (const auto& [text, error] : {std::pair{"0.003", 0.003}, {"0.01", 0.01}, {"0.03", 0.03}}) {
    SpectralRoom truncated = compressed_room(text, "256");
    EXPECT_LT(truncated.transfer().one_bounce.coefficients(), before);
    before = truncated.transfer().one_bounce.coefficients();
    double of_both = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i)
      of_both += squared_error(transferred(truncated, lights[i]), expected[i]) / 40.0;
    EXPECT_LT(of_both - of_rays, error * error) << text;
    EXPECT_GT(of_both, 0.0);
  }
}

TEST(SpectralTransfer, RaysAboutOneVertexAreCosineDistributedAndDiffer) {
  const DirectionSet set(4096, 1);
  const auto directions_of = [&](std::uint32_t vertex) {
    const DirectionSet::Turn turn = DirectionSet::turn(1, vertex, {0.0F, 0.0F, 1.0F});
    std::vector<Vec3> directions;
    DirectionBatch batch;
    for (std::size_t begin = 0; begin < set.size(); begin += batch.count) {
      set.directions(turn, begin, batch);
      for (std::size_t i = 0; i < batch.count; ++i) directions.push_back(batch.direction(i));
    }
    return directions;
  };
  const std::vector<Vec3> first = directions_of(0), second = directions_of(1);
  EXPECT_NE(first.front(), second.front());
  for (const auto& directions : {first, second}) {
    Vec3d mean(0.0);
    double squared = 0.0;
    for (const Vec3& d : directions) {
      mean += Vec3d(d) / 4096.0;
      squared += static_cast<double>(d.z * d.z) / 4096.0;
      EXPECT_NEAR(glm::length(d), 1.0F, 1e-5F);
      EXPECT_GE(d.z, 0.0F);
    }
    EXPECT_NEAR(mean.x, 0.0, 2e-3);
    EXPECT_NEAR(mean.y, 0.0, 2e-3);
    EXPECT_NEAR(mean.z, 2.0 / 3.0, 2e-3);
    EXPECT_NEAR(squared, 0.5, 2e-3);
  }
}

TEST(SpectralTransfer, NothingPassesAThinWall) {
  // Two rooms on one floor, a wall of a millimetre between them.
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.room("rooms", white, Vec3(0.0F), Vec3(2.0F, 1.0F, 1.0F));
  builder.block("wall", white, {0.995F, 0.0F, 0.0F}, {0.996F, 1.0F, 1.0F});
  SpectralRoom room(builder.build("two rooms"), {{"vertices", "2000"}, {"basis_functions", "200"}, {"rays", "256"}});
  std::vector<Rgb4> light;
  const auto is_lit = [&](std::uint32_t slot) { return room.transfer().node_at(slot).position.x < 0.9955F; };
  for (std::uint32_t slot = 0; slot < room.slots(); ++slot) light.emplace_back(Rgb(is_lit(slot) ? 1.0F : 0.0F));
  const std::vector<Rgb4> answer = transferred(room, light);
  for (std::uint32_t slot = 0; slot < room.slots(); ++slot) {
    const Node& vertex = room.transfer().node_at(slot);
    if (vertex.object == 1 && std::fabs(vertex.normal.x) < 0.5F) continue;  // the wall's edges lie in the room's own walls
    EXPECT_NEAR(answer[slot].r, is_lit(slot) ? pi : 0.0F, 0.03F * pi);
  }
}

TEST(SpectralTransfer, RowsOfABlockAreThoseOfItsVertices) {
  SpectralRoom room(closed_room(), {{"vertices", "300"}, {"basis_functions", "40"}, {"rays", "64"}, {"compression_error", "0"}});
  const std::size_t columns = room.transfer().basis.columns();
  const VertexRays rays = room.rays();
  TransferRows maker(room.transfer().basis, rays);
  RayStream stream = room.task.rays(room.world);
  std::vector<float> together(5 * columns), alone(columns);
  maker.irradiance(std::span(room.transfer().node_of_slot).subspan(40, 5), stream, together);
  for (std::size_t i = 0; i < 5; ++i) {
    maker.irradiance(room.transfer().node_of_slot[40 + i], stream, alone);
    for (std::size_t c = 0; c < columns; ++c) EXPECT_NEAR(together[i * columns + c], alone[c], 1e-5F);
  }
}

TEST(SpectralTransfer, AMakerOfRowsKeepsNothingFromOneBlockToTheNext) {
  SpectralRoom room(closed_room(), {{"vertices", "300"}, {"basis_functions", "40"}, {"rays", "64"}, {"compression_error", "0"}});
  const std::size_t columns = room.transfer().basis.columns();
  const VertexRays rays = room.rays();
  RayStream stream = room.task.rays(room.world);
  TransferRows kept(room.transfer().basis, rays);
  const auto vertices = std::span(room.transfer().node_of_slot);
  for (std::uint32_t slot = 0; slot + 8 <= room.slots(); slot += 40) {
    TransferRows fresh(room.transfer().basis, rays);
    std::vector<float> expected(8 * columns), made(8 * columns), slices(harmonic_count * columns);
    fresh.irradiance(vertices.subspan(slot, 8), stream, expected);
    kept.irradiance(vertices.subspan(slot, 8), stream, made);
    EXPECT_EQ(made, expected);
    kept.with_harmonics(vertices[slot], stream, slices);
  }
}

TEST(SpectralTransfer, NoLightOfAFloorIsTakenFromUnderTheBlocksThatStandOnIt) {
  // Hollow blocks sunk into the floor at several angles: vertices under them see nothing, and beside them all of the room.
  for (const float degrees : {3.0F, 17.0F, 30.0F, 45.0F}) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
    builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
    builder.block("block", white, {0.3F, -0.1F, 0.35F}, {0.6F, 0.4F, 0.7F}, degrees);
    SpectralRoom room(builder.build("block on a floor"),
                      {{"vertices", "3000"}, {"basis_functions", "16"}, {"rays", "128"}, {"compression_error", "0"}});
    const VertexRays rays = room.rays();
    TransferRows rows(room.transfer().basis, rays);
    RayStream stream = room.task.rays(room.world);
    std::vector<std::vector<float>> weights(room.slots(), std::vector<float>(room.slots()));
    std::vector<float> seen(room.slots(), 0.0F);
    for (std::uint32_t slot = 0; slot < room.slots(); ++slot) {
      rows.nodal(room.transfer().node_of_slot[slot], stream, weights[slot]);
      for (const float weight : weights[slot]) seen[slot] += weight / pi;
    }
    for (std::uint32_t slot = 0; slot < room.slots(); ++slot) {
      if (seen[slot] < 0.5F) continue;
      float dark = 0.0F;
      for (std::uint32_t j = 0; j < room.slots(); ++j) dark += seen[j] < 0.5F ? weights[slot][j] / pi : 0.0F;
      const Vec3 at = room.transfer().node_at(slot).position;
      EXPECT_LT(dark, 0.02F) << degrees << " degrees, at " << at.x << " " << at.y << " " << at.z;
    }
  }
}

/// Light that comes from the room's ceiling alone, gathered at the block's top with each harmonic as weight.
TEST(SpectralTransfer, HarmonicSlicesAreMomentsOfTheArrivingLight) {
  TransferWish wish;
  wish.glossy_objects = {false, true};
  SpectralRoom room(closed_room(),
                    {{"vertices", "400"}, {"basis_functions", "65528"}, {"rays", "2048"}, {"compression_error", "0"}}, wish);
  const Transfer& transfer = room.transfer();
  ASSERT_EQ(transfer.harmonic_slices.size(), harmonic_count - 1);
  std::vector<Rgb4> light, projected(transfer.basis.columns());
  for (const std::uint32_t node : transfer.node_of_slot) light.emplace_back(Rgb(1.0F + transfer.nodes[node].position.y));
  transfer.basis.project(light, projected, room.task);
  const VertexRays rays = room.rays();
  RayStream stream = room.task.rays(room.world);
  for (std::size_t row = 0; row < transfer.glossy_slots.size(); row += 7) {
    Harmonics expected{};
    rays.trace(transfer.node_of_slot[transfer.glossy_slots[row]], stream, [&](std::span<const MeshHit> hits) {
      for (const MeshHit& hit : hits) {
        const Harmonics h = spherical_harmonics(hit.direction);
        rays.each_slot(hit, [&](std::uint32_t slot, float weight) {
          for (std::size_t k = 0; k < harmonic_count; ++k) expected[k] += h[k] * weight * light[slot].r;
        });
      }
    });
    for (std::size_t k = 1; k < harmonic_count; ++k) {
      std::vector<Rgb4> slice(transfer.glossy_slots.size());
      transfer.harmonic_slices[k - 1].multiply(projected, slice, room.task);
      EXPECT_NEAR(slice[row].r, expected[k], 1e-3F);
    }
  }
}

TEST(SpectralTransfer, CompressionOfGlossySlicesIsJudgedByThemselves) {
  TransferWish wish;
  wish.glossy_objects = {true, true};
  const auto glossy_room = [&](const std::string& error, const std::string& rays) {
    return SpectralRoom(closed_room(),
                        {{"vertices", "600"}, {"basis_functions", "120"}, {"rays", rays}, {"compression_error", error}}, wish);
  };
  SpectralRoom truth = glossy_room("0", "4096"), exact = glossy_room("0", "256");
  const std::vector<std::vector<Rgb4>> lights = lamps(exact, 20);
  const auto slices = [&](SpectralRoom& room, const std::vector<Rgb4>& light) {
    std::vector<Rgb4> projected(room.transfer().basis.columns()), all;
    room.transfer().basis.project(light, projected, room.task);
    for (const TransferMatrix& matrix : room.transfer().harmonic_slices) {
      std::vector<Rgb4> slice(matrix.rows());
      matrix.multiply(projected, slice, room.task);
      all.insert(all.end(), slice.begin(), slice.end());
    }
    return all;
  };
  for (const auto& [text, error] : {std::pair{"0.01", 0.01}, {"0.03", 0.03}}) {
    SpectralRoom truncated = glossy_room(text, "256");
    EXPECT_LT(truncated.transfer().harmonic_slices.front().coefficients(),
              exact.transfer().harmonic_slices.front().coefficients());
    double added = 0.0;
    for (const std::vector<Rgb4>& light : lights) {
      const std::vector<Rgb4> expected = slices(truth, light);
      added += (squared_error(slices(truncated, light), expected) - squared_error(slices(exact, light), expected)) / 20.0;
    }
    EXPECT_LT(added, error * error) << text;
  }
}

/// Loose quads, every other one of them glossy, so that hardly a block of the matrix is glossy throughout.
TEST(SpectralTransfer, SlicesOfGlossyNodesAmongOthersFillTheirBlocks) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  TransferWish wish;
  wish.glossy_objects = {false};
  for (int i = 0; i < 64; ++i) {
    const Vec3 at(0.1F + 0.1F * static_cast<float>(i % 8), 0.5F, 0.1F + 0.1F * static_cast<float>(i / 8));
    builder.object("quad " + std::to_string(i), white,
                   {at, at + Vec3(0, 0, 0.05F), at + Vec3(0.05F, 0, 0.05F), at + Vec3(0.05F, 0, 0)}, {{0, 1, 2, 3}});
    wish.glossy_objects.push_back(i % 2 == 0);
  }
  SpectralRoom room(builder.build("quads"),
                    {{"vertices", "400"}, {"basis_functions", "200"}, {"rays", "64"}, {"compression_error", "0"}}, wish);
  const Transfer& transfer = room.transfer();
  ASSERT_EQ(transfer.glossy_slots.size(), 32U * 4U);
  for (std::uint32_t row = 0; row < transfer.glossy_slots.size(); ++row)
    EXPECT_EQ(transfer.glossy_row[transfer.glossy_slots[row]], row);
  for (const TransferMatrix& slice : transfer.harmonic_slices) {
    ASSERT_EQ(slice.rows(), transfer.glossy_slots.size());
    // Of 4 bytes each, an eighth of a column's two, and what the matrix holds for each of its columns; half empty ones took 8.
    EXPECT_LT(slice.bytes(), slice.coefficients() * 5 + slice.columns() * 16);
  }
}

/// Stopped at one sign of progress after the other, the making comes to an end by itself.
TEST(SpectralTransfer, AStopAtAnySignOfProgressIsNoFailure) {
  const World world(closed_room(), 1);
  TransferWish wish;
  wish.glossy_objects = {false, true};
  wish.reflectance.assign(2, Rgb(0.1F));
  for (const char* mode : {"bounces", "fixed_albedo"}) {
    const Settings settings = spectral_settings({{"vertices", "200"}, {"basis_functions", "32"}, {"rays", "16"}, {"mode", mode}});
    bool finished = false;
    int stopped_at = 1;
    for (; !finished; ++stopped_at) {
      int signs = 0;
      const auto flag = std::make_shared<std::atomic<bool>>(false);
      Task task({.cancel = flag, .on_progress = [&](const ProgressPoint&) {
                   if (++signs == stopped_at) flag->store(true);
                 }});
      EXPECT_NO_THROW(make_transfer(world, settings, wish, task)) << "stopped at sign " << stopped_at;
      finished = !flag->load();
    }
    EXPECT_GT(stopped_at, 6);
  }
}

TEST(SpectralTransfer, OnlyWhatIsWishedForIsMade) {
  SpectralRoom room(closed_room(), {{"vertices", "300"}, {"basis_functions", "20"}, {"rays", "16"}});
  EXPECT_TRUE(room.transfer().harmonic_slices.empty());
  EXPECT_TRUE(room.transfer().all_bounces.empty());
  EXPECT_EQ(room.task.counters()["glossy_vertices"], 0U);
  // The rays of the vertices, those of the pilots with a quarter for each of two others, and those that place the lights tried
  // out.
  EXPECT_LE(room.task.counters()["closest_hit_rays"], 16U * room.slots() + (16U + 2U * 4U) * 512U + 72U);
}

}  // namespace
}  // namespace gibench::test
