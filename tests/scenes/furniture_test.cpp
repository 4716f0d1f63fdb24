/// Furniture is made of closed parts that face outwards; what is thin is open; rooms have the areas that their walls say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "scenes/generators/furniture/books.h"
#include "scenes/generators/furniture/casework.h"
#include "scenes/generators/furniture/crockery.h"
#include "scenes/generators/furniture/lamps.h"
#include "scenes/generators/furniture/plants.h"
#include "scenes/generators/furniture/seating.h"
#include "scenes/generators/library.h"
#include "scenes/generators/living_room.h"
#include "scenes/generators/rooms.h"
#include "tests/scenes/mesh_facts.h"

namespace gibench::generators {
namespace {

RandomStream stream() { return {1, 2, 3}; }

struct Piece {
  const char* name;
  Mesh mesh;
};

/// All that is not thin.
std::vector<Piece> closed_pieces() {
  RandomStream random = stream();
  const Seat seat = chair(10), couch = sofa(2);
  const Book volume = book(0.03, 0.25, 0.18), open = open_book(0.3, 0.2);
  const BookRow row = book_row(1.2, 0.3, 0.035, random);
  const Lamp standing = floor_lamp(1.6), small = table_lamp(), reading = reading_lamp(), hanging = pendant(1.1, 0.25),
             candles = chandelier(1.5, 0.5, 6);
  const Plant grass = grassy_plant(0.12, 0.5, 9, random), leafy = leafy_plant(0.15, 1.0, 3, 5, random);
  const Picture framed = picture(0.6, 0.4);
  const Floorboards floor = floorboards(3.0, 2.0, 0.15, random);
  return {{"chair", seat.frame},
          {"chair cushion", seat.upholstery},
          {"sofa", couch.frame},
          {"sofa cushions", couch.upholstery},
          {"pillow", pillow(0.4)},
          {"table", table({1.5, 0.75, 0.9}, 12)},
          {"side table", side_table(0.25, 0.5)},
          {"bookcase", bookcase({})},
          {"cupboard", cupboard({1.2, 0.9, 0.4}, 2)},
          {"door", panelled_door(0.9, 2.0)},
          {"ladder", ladder(0.5, 3.0, 0.7, 9)},
          {"radiator", radiator(1.2, 0.5)},
          {"frame", framed.frame},
          {"canvas", framed.canvas},
          {"cover", volume.cover},
          {"pages", volume.pages},
          {"open cover", open.cover},
          {"open pages", open.pages},
          {"row of covers", row.covers[0]},
          {"row of pages", row.pages},
          {"plate", plate(0.13)},
          {"bowl", bowl(0.14, 0.08)},
          {"cup", cup()},
          {"teapot", teapot()},
          {"vase", vase(0.25, 0.05, 1.7)},
          {"candlestick", candlestick(0.14)},
          {"floor lamp", standing.stand},
          {"bulb", standing.bulb},
          {"table lamp", small.stand},
          {"reading lamp", reading.stand},
          {"tube", reading.bulb},
          {"pendant", hanging.stand},
          {"chandelier", candles.stand},
          {"candles", candles.bulb},
          {"pot", grass.pot},
          {"earth", grass.earth},
          {"tuft", grass.stems},
          {"stems", leafy.stems},
          {"boards", floor.tones[1]},
          {"window bars", window_bars({0.5, 0.8, 2.0, 2.2}, 3, 2, 0.05, 0.2)},
          {"skirting", skirting(2.0)}};
}

TEST(Furniture, IsMadeOfClosedPartsThatFaceOutwards) {
  for (const auto& [name, mesh] : closed_pieces()) {
    const MeshFacts facts = facts_of(mesh, 0.0);
    EXPECT_EQ(facts.unmatched_edges, 0U) << name;
    EXPECT_EQ(facts.degenerate_faces, 0U) << name;
    ASSERT_FALSE(facts.part_volumes.empty()) << name;
    EXPECT_GT(*std::min_element(facts.part_volumes.begin(), facts.part_volumes.end()), 0.0) << name;
  }
}

TEST(Furniture, HasTheVolumeOfItsShape) {
  EXPECT_NEAR(facts_of(cushion(Vec3d(0.5), 1.0, 60, 90)).volume, 4.0 / 3.0 * pi_double * 0.125, 0.01 * 0.5236);  // chords: 0.3%
  EXPECT_NEAR(facts_of(pipe({{0, 0, 0}, {1, 2, 2}}, 90, 0.1)).volume, 3.0 * pi_double * 0.01, 1e-3 * 0.0942);  // 90 chords: 0.08%
  const double board = 0.003, thickness = 0.03, height = 0.25, depth = 0.18;
  EXPECT_NEAR(facts_of(book(thickness, height, depth).cover).volume, height * board * (2.0 * depth + thickness - 2.0 * board),
              1e-12);
}

TEST(Furniture, BooksOfARowStandApart) {
  RandomStream random = stream();
  const BookRow row = book_row(2.0, 0.32, 0.035, random);
  std::size_t books = 0;
  for (const Mesh& covers : row.covers) books += facts_of(covers, 0.0).part_volumes.size();
  EXPECT_EQ(books, facts_of(row.pages, 0.0).part_volumes.size());
  EXPECT_GT(books, 30U);
  for (const Mesh& covers : row.covers)
    for (const Vec3d& vertex : covers.vertices) EXPECT_GT(vertex.y, 0.0) << "nothing reaches into the board";
}

TEST(Furniture, LeavesAreLoose) {
  RandomStream random = stream();
  const Plant plant = leafy_plant(0.15, 1.0, 3, 5, random);
  EXPECT_EQ(facts_of(plant.leaves, 0.0).part_volumes.size(), 15U);
}

TEST(Rooms, AWallHasTheAreaOfItsFaceAndItsReveals) {
  const double face = 4.0 * 2.5 - 1.0 * 1.2, reveals = 0.3 * 2.0 * (1.0 + 1.2);
  EXPECT_NEAR(facts_of(wall(4.0, 2.5, {{1.0, 0.8, 2.0, 2.0}}, 0.3)).area, face + reveals, 1e-9);
}

TEST(Rooms, WallsAndCeilingLookInwards) {
  const Vec3d size(4.0, 2.5, 3.0), middle = 0.5 * size;
  Mesh room = room_walls(size, {}, 0.2);
  room.append(room_ceiling(size, {}, 0.2));
  for (const auto& [a, b, c, d] : room.faces) {
    const Vec3d normal = glm::cross(room.vertices[b] - room.vertices[a], room.vertices[c] - room.vertices[a]);
    EXPECT_GT(glm::dot(normal, middle - room.vertices[a]), 0.0);
  }
}

/// Triangles and objects of a scene as it was written.
struct Written {
  std::size_t triangles = 0, objects = 0;
};

Written write(std::size_t (*make)(const std::filesystem::path&), const char* name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "gibench-furnished";
  Written written;
  written.triangles = make(folder);
  const auto scene = nlohmann::json::parse(read_file(folder / (std::string(name) + ".scene.json")));
  written.objects = scene.at("objects").size();
  std::filesystem::remove_all(folder);
  return written;
}

TEST(FurnishedRooms, HaveHundredsOfObjects) {
  const Written living = write(write_living_room, "living-room"), hall = write(write_library, "library");
  EXPECT_GE(living.objects, 300U);
  EXPECT_GE(living.triangles, 50'000U);
  EXPECT_GE(hall.objects, 300U);
  EXPECT_GE(hall.triangles, 450'000U);
}

}  // namespace
}  // namespace gibench::generators
