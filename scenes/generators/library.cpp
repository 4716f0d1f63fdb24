#include "scenes/generators/library.h"

#include <cmath>
#include <string>

#include "scenes/generators/figure.h"
#include "scenes/generators/furnishing.h"
#include "scenes/generators/furniture/crockery.h"
#include "scenes/generators/rooms.h"

namespace gibench::generators {

namespace {

using Json = nlohmann::ordered_json;

constexpr Vec3d room(14.0, 6.2, 8.0);  // metres; three windows in the wall x = 0
constexpr double apart = 0.001;        // between what lies and what it lies on
constexpr double gallery_height = 3.32, gallery_depth = 1.15;
constexpr int cases = 5;
constexpr Opening skylight{4.0, 3.0, 10.0, 5.0};  // x and z
const CaseShape lower_case{2.3, 3.1, 0.34, 8}, upper_case{2.3, 2.3, 0.34, 6};

double case_left(int index) { return 0.85 + 2.5 * index; }

/// The reading hall under construction.
struct Hall {
  SceneWriter& writer;
  Furnishing furnishing;
  RandomStream random;

  explicit Hall(SceneWriter& scene) : writer(scene), furnishing(scene), random(1, 0x6c696272617279ULL, 0) {}

  void build_shell();
  void build_galleries();
  void build_cases();
  void fill_case(const std::string& level, const CaseShape& shape, int rows, const Vec3d& corner, double turn);
  void build_tables();
  void build_table_clutter(const Vec3d& middle);
  void build_statues();
  void build_lamps();
  void build_corners();
};

std::vector<Opening> windows() {
  std::vector<Opening> result;
  for (const double middle : {2.1, 4.0, 5.9}) result.push_back({middle - 0.6, 1.0, middle + 0.6, 5.3});
  return result;
}

void Hall::build_shell() {
  writer.add("walls", "plaster", room_walls(room, {{{}, windows(), {}, {}}}, 0.35));
  writer.add("ceiling", "white", room_ceiling(room, {skylight}, 0.5));
  const Floorboards floor = floorboards(room.x, room.z, 0.2, random);
  for (std::size_t tone = 0; tone < 3; ++tone)
    writer.add("floorboards " + std::to_string(tone + 1), "oak " + std::to_string(tone + 1), floor.tones[tone]);
  writer.add("under the boards", "earth", floor.under);
  Mesh bars;
  for (const Opening& window : windows())
    bars.append(placed(window_bars(window, 3, 6, 0.05, 0.25), {0.0, 0.0, room.z}, {0.0, 90.0, 0.0}));
  bars.append(placed(window_bars(skylight, 8, 3, 0.07, 0.3), {0.0, room.y, 0.0}, {90.0, 0.0, 0.0}));
  writer.add("window bars", "white", bars);
  Mesh beams;
  for (const double x : {0.7, 1.8, 2.9, 11.1, 12.2, 13.3})
    beams.append(block({x - 0.11, room.y - 0.22, 0.003}, {x + 0.11, room.y - 0.002, room.z - 0.003}));
  for (const double z : {1.2, 2.6, 5.4, 6.8})
    beams.append(block({0.003, room.y - 0.16, z - 0.09}, {room.x - 0.003, room.y - 0.003, z + 0.09}));
  writer.add("beams", "wood", beams);
  Mesh ends = placed(skirting(room.z - 1.0), {0.0, apart, room.z - 0.5}, {0.0, 90.0, 0.0});
  ends.append(placed(skirting(room.z - 1.0), {room.x, apart, 0.5}, {0.0, -90.0, 0.0}));
  writer.add("skirting", "wood", ends);
  for (const double z : {3.1, 4.0}) writer.place("door", "door", "wood", {{room.x - 0.003, 0.004, z}, -90.0});
}

/// A row of them over the length of the hall.
Mesh balusters() {
  constexpr double distance = 0.15;  // metres
  const Mesh one = lathe({{0.0, 0.0},
                          {0.03, 0.0},
                          {0.03, 0.05},
                          {0.014, 0.07},
                          {0.02, 0.14},
                          {0.034, 0.27},
                          {0.028, 0.38},
                          {0.013, 0.5},
                          {0.018, 0.62},
                          {0.012, 0.7},
                          {0.03, 0.76},
                          {0.03, 0.8},
                          {0.0, 0.8}},
                         12);
  Mesh row;
  for (double x = 0.1; x < room.x - 0.1; x += distance) row.append(placed(one, {x, 0.0, 0.0}));
  return row;
}

/// A walk along both long walls over the lower cases, on pillars, with a turned balustrade.
void Hall::build_galleries() {
  writer.model("gallery", block({0.02, gallery_height - 0.12, 0.01}, {room.x - 0.02, gallery_height, gallery_depth}));
  writer.model("balusters", balusters());
  writer.model("hand rail", pipe({{0.03, 0.0, 0.0}, {room.x - 0.03, 0.0, 0.0}}, 16, 0.04));
  writer.model("pillar", lathe({{0.0, 0.0},
                                {0.13, 0.0},
                                {0.13, 0.06},
                                {0.10, 0.12},
                                {0.085, 0.18},
                                {0.07, gallery_height - 0.4},
                                {0.09, gallery_height - 0.36},
                                {0.075, gallery_height - 0.3},
                                {0.13, gallery_height - 0.13},
                                {0.0, gallery_height - 0.12}},
                               24));
  for (const bool back : {true, false}) {
    const auto at = [&](double x, double y, double z) { return back ? Vec3d(x, y, z) : Vec3d(room.x - x, y, room.z - z); };
    const double turn = back ? 0.0 : 180.0;
    writer.place("gallery", "gallery", "wood", {at(0, 0, 0), turn});
    writer.place("balusters", "balusters", "wood", {at(0, gallery_height + apart, gallery_depth - 0.08), turn});
    writer.place("hand rail", "hand rail", "wood", {at(0, gallery_height + 0.82, gallery_depth - 0.08), turn});
    for (int i = 0; i < cases + 1; ++i)
      writer.place("pillar", "pillar", "wood", {at(case_left(i) - 0.1, apart, gallery_depth - 0.16), turn});
  }
}

void Hall::build_cases() {
  writer.model("lower case", bookcase(lower_case));
  writer.model("upper case", bookcase(upper_case));
  constexpr int rows = 12;
  for (int i = 0; i < rows; ++i) {
    furnishing.model("lower row " + std::to_string(i), book_row(lower_case.width - 0.06, lower_case.room(), 0.036, random));
    furnishing.model("upper row " + std::to_string(i), book_row(upper_case.width - 0.06, upper_case.room(), 0.033, random));
  }
  for (const bool back : {true, false})
    for (int i = 0; i < cases; ++i) {
      const auto corner = [&](double y) {
        return back ? Vec3d(case_left(i), y, 0.016) : Vec3d(room.x - case_left(i), y, room.z - 0.016);
      };
      fill_case("lower", lower_case, rows, corner(apart), back ? 0.0 : 180.0);
      fill_case("upper", upper_case, rows, corner(gallery_height + apart), back ? 0.0 : 180.0);
    }
}

void Hall::fill_case(const std::string& level, const CaseShape& shape, int rows, const Vec3d& corner, double turn) {
  writer.place(level + " case", level + " case", "wood", {corner, turn});
  const double way = turn == 0.0 ? 1.0 : -1.0;
  for (int shelf = 0; shelf < shape.shelves; ++shelf) {
    const Vec3d at = corner + Vec3d(way * 0.028, shape.level(shelf), way * (shape.depth - 0.03));
    furnishing.place_row(level + " row " + std::to_string(static_cast<int>(between(random, 0.0, rows))), at, turn,
                         static_cast<std::size_t>(between(random, 0.0, static_cast<double>(cover_colours))));
  }
}

void Hall::build_tables() {
  writer.add("carpet", "rug", cushion({4.6, 0.006, 1.5}, 0.1, 6, 60), {{7.0, 0.008, 4.0}});
  writer.model("table", table({3.4, 0.76, 1.15}, 24));
  furnishing.model("chair", chair(14));
  for (const double x : {4.7, 9.0}) {
    const Vec3d middle(x, 0.015, 4.0);
    writer.place("table", "table", "wood", {middle});
    build_table_clutter(middle + Vec3d(0.0, 0.76 + apart, 0.0));
    for (int i = 0; i < 4; ++i)
      for (const double side : {-1.0, 1.0}) {
        if (i == 2 && side > 0.0) continue;  // taken to the window
        const Vec3d at =
            middle + Vec3d(-1.2 + 0.8 * i + between(random, -0.06, 0.06), 0.0, side * (0.62 + between(random, 0.0, 0.3)));
        furnishing.place_seat("chair", at, (side > 0.0 ? 180.0 : 0.0) + between(random, -14.0, 14.0), "leather");
      }
  }
}

/// Lamps, piles of books, open books and cups.
void Hall::build_table_clutter(const Vec3d& middle) {
  for (const double x : {-0.85, 0.85}) furnishing.place_lamp("reading lamp", middle + Vec3d(x, 0.0, 0.0), 0.0, "brass", "glass");
  for (int i = 0; i < 7; ++i) {
    const Vec3d at = middle + Vec3d(-1.45 + 0.46 * i, 0.0, (i % 2 == 0 ? -0.33 : 0.33) + between(random, -0.05, 0.05));
    const double turn = between(random, -25.0, 25.0) + (i % 2 == 0 ? 180.0 : 0.0);
    if (i % 3 != 1) {
      furnishing.place_book("open book", {at, turn}, static_cast<std::size_t>(i));
      continue;
    }
    double y = 0.0;
    for (int volume = 0; volume < 4; ++volume) {
      const double size = between(random, 0.75, 1.1);
      furnishing.place_book("lying book", {at + Vec3d(0.0, y, 0.0), turn + between(random, -12.0, 12.0), Vec3d(size, 1.0, size)},
                            static_cast<std::size_t>(between(random, 0.0, 5.0)));
      y += 0.034 + apart;
    }
  }
  writer.place("cup", "cup", "porcelain", {middle + Vec3d(0.32, 0.0, -0.2), 50.0});
  writer.place("vase", "vase", "porcelain", {middle + Vec3d(0.02, 0.0, 0.05)});
}

void Hall::build_statues() {
  writer.model("pedestal", block({-0.27, 0.0, -0.27}, {0.27, 0.95, 0.27}));
  for (const double z : {3.05, 4.95}) {
    const std::string name = z < 4.0 ? "first statue" : "second statue";
    writer.place("pedestal", "pedestal", "marble", {{0.55, apart, z}});
    writer.add(name, "marble", figure(z < 4.0 ? 2 : 5, 110, 120), {{0.55, 0.95 + 2 * apart, z}, 90.0, Vec3d(0.75)});
  }
}

void Hall::build_lamps() {
  furnishing.model("chandelier", chandelier(1.9, 0.62, 8));
  for (const double x : {2.35, 11.65}) furnishing.place_lamp("chandelier", {x, room.y - 0.16 - apart, 4.0});
  furnishing.model("floor lamp", floor_lamp(1.6));
  furnishing.place_lamp("floor lamp", {1.2, apart, 6.6});
}

void Hall::build_corners() {
  furnishing.model("armchair", sofa(1));
  furnishing.place_seat("armchair", {1.9, apart, 6.0}, 130.0, "leather");
  furnishing.place_seat("armchair", {1.9, apart, 2.0}, 50.0, "leather");
  furnishing.place_seat("chair", {1.2, apart, 3.9}, 75.0, "leather");
  writer.add("side table", "wood", side_table(0.28, 0.55), {{2.3, apart, 5.1}});
  writer.place("cup", "cup", "porcelain", {{2.35, 0.55 + 2 * apart, 5.15}, 120.0});
  writer.model("ladder", ladder(0.5, 3.0, 0.75, 9));
  writer.place("ladder", "ladder", "pine", {{7.3, 0.003, 0.42}});
  writer.place("ladder", "ladder", "pine", {{5.4, 0.003, room.z - 0.42}, 180.0});
  writer.add(
      "globe stand", "wood",
      lathe({{0.0, 0.0}, {0.24, 0.0}, {0.24, 0.04}, {0.05, 0.08}, {0.04, 0.3}, {0.06, 0.34}, {0.03, 0.42}, {0.0, 0.42}}, 30),
      {{11.6, apart, 2.4}});
  writer.add("globe", "glaze", cushion(Vec3d(0.36), 1.0, 36, 56), {{11.6, 0.79, 2.4}});
  furnishing.model("palm", grassy_plant(0.2, 1.3, 70, random));
  furnishing.place_plant("palm", {0.5, apart, 7.3});
  furnishing.place_plant("palm", {0.5, apart, 0.8}, 70.0);
  furnishing.model("rubber plant", leafy_plant(0.18, 1.3, 6, 14, random));
  furnishing.place_plant("rubber plant", {11.9, apart, 6.2});
  furnishing.place_plant("rubber plant", {12.9, apart, 2.3}, 120.0);
  furnishing.model("picture", picture(0.9, 1.2));
  furnishing.place_picture("picture", {room.x - 0.002, 1.9, 1.9}, -90.0, "canvas");
  furnishing.place_picture("picture", {room.x - 0.002, 1.9, 6.1}, -90.0, "canvas");
}

/// What several parts of the hall place.
void write_shared_models(Hall& hall) {
  hall.writer.model("door", panelled_door(0.88, 2.3));
  hall.writer.model("cup", cup());
  hall.writer.model("vase", vase(0.24, 0.045, 1.8));
  hall.furnishing.model("reading lamp", reading_lamp());
  hall.furnishing.model("open book", open_book(0.34, 0.24));
  const Book upright = book(0.034, 0.27, 0.2);  // lain on its board, about its middle
  hall.furnishing.model("lying book", Book{placed(upright.cover, {0.135, 0.0, 0.1}, {0.0, 0.0, 90.0}),
                                           placed(upright.pages, {0.135, 0.0, 0.1}, {0.0, 0.0, 90.0})});
}

Json materials() {
  return {
      {"plaster", diffuse(0.72, 0.69, 0.60)}, {"white", diffuse(0.78, 0.77, 0.74)},   {"oak 1", diffuse(0.40, 0.27, 0.16)},
      {"oak 2", diffuse(0.35, 0.23, 0.13)},   {"oak 3", diffuse(0.44, 0.31, 0.19)},   {"wood", diffuse(0.30, 0.17, 0.09)},
      {"pine", diffuse(0.55, 0.41, 0.25)},    {"rug", diffuse(0.36, 0.10, 0.09)},     {"leather", diffuse(0.28, 0.12, 0.07)},
      {"brass", diffuse(0.48, 0.36, 0.15)},   {"shade", diffuse(0.72, 0.66, 0.54)},   {"glass", diffuse(0.10, 0.38, 0.24)},
      {"bulb", glowing(70.0, 50.0, 28.0)},    {"marble", diffuse(0.76, 0.75, 0.71)},  {"porcelain", diffuse(0.78, 0.78, 0.76)},
      {"glaze", diffuse(0.20, 0.32, 0.40)},   {"clay", diffuse(0.52, 0.27, 0.16)},    {"earth", diffuse(0.10, 0.07, 0.05)},
      {"stem", diffuse(0.22, 0.26, 0.10)},    {"leaf", diffuse(0.14, 0.30, 0.09)},    {"paper", diffuse(0.74, 0.69, 0.57)},
      {"canvas", diffuse(0.34, 0.28, 0.17)},  {"cover 1", diffuse(0.34, 0.10, 0.08)}, {"cover 2", diffuse(0.13, 0.22, 0.16)},
      {"cover 3", diffuse(0.48, 0.33, 0.17)}, {"cover 4", diffuse(0.16, 0.18, 0.30)}, {"cover 5", diffuse(0.56, 0.48, 0.34)}};
}

}  // namespace

std::size_t write_library(const std::filesystem::path& folder) {
  SceneWriter writer(folder, "library");
  Hall hall(writer);
  write_shared_models(hall);
  hall.build_shell();
  hall.build_galleries();
  hall.build_cases();
  hall.build_tables();
  hall.build_statues();
  hall.build_lamps();
  hall.build_corners();
  return writer.write({{"description",
                        "A reading hall with thousands of books by day: windows, a skylight and lamps, loose pieces and clutter; "
                        "made by scenes/generators/."},
                       {"materials", materials()},
                       {"lights",
                        {{{"type", "directional"}, {"direction", {0.62, -0.74, 0.26}}, {"irradiance", {14.0, 12.8, 10.8}}},
                         {{"type", "environment"}, {"radiance", {1.3, 1.65, 2.2}}}}},
                       {"cameras",
                        {{{"name", "main"},
                          {"position", {13.3, 1.75, 5.0}},
                          {"look_at", {3.0, 2.0, 3.75}},
                          {"vertical_fov_degrees", 60.0},
                          {"resolution", {320, 240}}},
                         {{"name", "table"},
                          {"position", {7.0, 1.65, 5.9}},
                          {"look_at", {4.4, 0.95, 3.6}},
                          {"vertical_fov_degrees", 50.0},
                          {"resolution", {320, 240}}}}},
                       {"exposure", {{"value", 1.6}, {"start", -2.0}, {"stop", 5.0}}}});
}

}  // namespace gibench::generators
