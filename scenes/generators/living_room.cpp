#include "scenes/generators/living_room.h"

#include <string>

#include "scenes/generators/furnishing.h"
#include "scenes/generators/furniture/crockery.h"
#include "scenes/generators/rooms.h"

namespace gibench::generators {

namespace {

using Json = nlohmann::ordered_json;

constexpr Vec3d room(6.4, 2.75, 4.8);                    // metres; the window is in the wall x = 0
constexpr double window_front = 3.5, window_back = 1.1;  // z of its sides
constexpr double sill = 0.85, lintel = 2.35, reveal = 0.28;
constexpr double apart = 0.001;  // between what lies and what it lies on

/// One furnished room under construction.
struct Room {
  SceneWriter& writer;
  Furnishing furnishing;
  RandomStream random;

  explicit Room(SceneWriter& scene) : writer(scene), furnishing(scene), random(1, 0x6c6976696e67ULL, 0) {}

  void build_shell();
  void build_window();
  void build_seating();
  void build_dining();
  void build_cases();
  void build_books(const CaseShape& shape, const Vec3d& corner);
  void build_plants();
  void build_coffee_table();
  void build_floor_clutter();
};

void Room::build_shell() {
  const Opening window{room.z - window_front, sill, room.z - window_back, lintel};
  writer.add("walls", "plaster", room_walls(room, {{{}, {window}, {}, {}}}, reveal));
  writer.add("ceiling", "white", room_ceiling(room, {}, 0.0));
  const Floorboards floor = floorboards(room.x, room.z, 0.16, random);
  for (std::size_t tone = 0; tone < 3; ++tone)
    writer.add("floorboards " + std::to_string(tone + 1), "oak " + std::to_string(tone + 1), floor.tones[tone]);
  writer.add("under the boards", "earth", floor.under);
  Mesh boards = placed(skirting(room.x), {0.0, apart, 0.0});
  boards.append(placed(skirting(room.z - 0.04), {0.0, apart, room.z - 0.02}, {0.0, 90.0, 0.0}));
  boards.append(placed(skirting(room.z - 0.04), {room.x, apart, 0.02}, {0.0, -90.0, 0.0}));
  writer.add("skirting", "white", boards);
  writer.add("door", "white", panelled_door(0.9, 2.05), {{5.7, 0.004, room.z - 0.003}, 180.0});
}

void Room::build_window() {
  const Opening window{room.z - window_front, sill, room.z - window_back, lintel};
  writer.add("window bars", "white", placed(window_bars(window, 3, 2, 0.05, 0.2), {0.0, 0.0, room.z}, {0.0, 90.0, 0.0}));
  writer.add("sill", "white", block({-0.15, sill + apart, window_back - 0.0}, {0.12, sill + 0.03, window_front}));
  writer.add("radiator", "white", radiator(1.8, 0.55), {{0.01, 0.002, 3.2}, 90.0});
  writer.add("curtain rail", "brass", pipe({{0.13, 2.56, 0.45}, {0.13, 2.56, 4.15}}, 14, 0.013));
  for (const double front : {1.22, 4.05})
    writer.add(front < 2.0 ? "back curtain" : "front curtain", "linen", curtain(0.62, 2.48, 7, random),
               {{0.13, 0.04, front}, 90.0, Vec3d(1.0), true});
}

void Room::build_seating() {
  writer.add("rug", "rug", cushion({1.35, 0.006, 0.9}, 0.15, 6, 40), {{3.05, 0.008, 1.85}});
  furnishing.model("sofa", sofa(3));
  furnishing.place_seat("sofa", {3.0, apart, 0.52}, 0.0, "sofa cloth");
  furnishing.model("armchair", sofa(1));
  furnishing.place_seat("armchair", {1.15, apart, 1.75}, 68.0, "armchair cloth");
  writer.model("pillow", pillow(0.42));
  writer.place("pillow", "pillow", "cover 2", {{1.98, 0.76, 0.62}, 22.0});
  writer.place("pillow", "pillow", "cover 4", {{2.32, 0.75, 0.66}, -8.0, Vec3d(0.9)});
  writer.place("pillow", "pillow", "linen", {{3.98, 0.76, 0.64}, -24.0});
  furnishing.model("picture", picture(0.62, 0.46));
  furnishing.model("small picture", picture(0.3, 0.4));
  furnishing.place_picture("picture", {3.0, 1.68, 0.002}, 0.0, "canvas 1");
  furnishing.place_picture("small picture", {2.28, 1.64, 0.002}, 0.0, "canvas 2");
  furnishing.place_picture("small picture", {3.72, 1.64, 0.002}, 0.0, "canvas 3");
  furnishing.model("floor lamp", floor_lamp(1.62));
  furnishing.place_lamp("floor lamp", {4.58, apart, 0.42});
}

void Room::build_dining() {
  const Vec3d middle(2.35, apart, 3.75);
  const double top = 0.75 + 2 * apart;
  writer.add("dining table", "wood", table({1.6, 0.75, 0.9}, 10), {middle});
  furnishing.model("chair", chair(8));
  for (const auto& [x, z, turn] : {std::array{-0.38, -0.62, 3.0}, {0.4, -0.7, -8.0}, {-0.36, 0.66, 176.0}, {0.42, 0.62, 183.0}})
    furnishing.place_seat("chair", middle + Vec3d(x, 0.0, z), turn, "cover 3");
  writer.model("plate", plate(0.13));
  writer.model("side plate", plate(0.08));
  writer.model("cup", cup());
  for (const auto& [x, z] : {std::array{-0.38, -0.27}, {0.4, -0.26}, {-0.36, 0.27}, {0.42, 0.28}}) {
    writer.place("plate", "plate", "porcelain", {middle + Vec3d(x, top, z)});
    writer.place("side plate", "side plate", "porcelain", {middle + Vec3d(x + 0.02, top + 0.0105, z)});
    writer.place("cup", "cup", "porcelain", {middle + Vec3d(x + 0.21, top, z * 0.75), 30.0 + 70.0 * x});
  }
  writer.add("tall vase", "glaze", vase(0.26, 0.045, 1.7), {middle + Vec3d(0.0, top, 0.02)});
  writer.model("candlestick", candlestick(0.14));
  writer.place("candlestick", "candlestick", "brass", {middle + Vec3d(-0.18, top, 0.05)});
  writer.place("candlestick", "candlestick", "brass", {middle + Vec3d(0.2, top, -0.04)});
  furnishing.model("pendant", pendant(1.15, 0.27));
  furnishing.place_lamp("pendant", {middle.x, room.y - apart, middle.z}, 0.0, "brass", "enamel");
}

void Room::build_cases() {
  const CaseShape shape{1.35, 2.1, 0.3, 6};
  const Vec3d corner(4.9, apart, 0.016);
  writer.add("bookcase", "pine", bookcase(shape), {corner});
  build_books(shape, corner);
  writer.add("sideboard", "wood", cupboard({1.6, 0.82, 0.44}, 3), {{room.x - 0.016, apart, 1.5}, -90.0});
  const auto on_sideboard = [](double along, double out) { return Vec3d(room.x - 0.016 - out, 0.82 + 2 * apart, 1.5 + along); };
  furnishing.model("table lamp", table_lamp());
  furnishing.place_lamp("table lamp", on_sideboard(0.3, 0.22), 0.0, "glaze");
  writer.add("wide vase", "clay", vase(0.2, 0.05, 2.0), {on_sideboard(1.2, 0.25)});
  writer.place("candlestick", "candlestick", "brass", {on_sideboard(0.85, 0.2)});
  furnishing.model("wide picture", picture(0.9, 0.55));
  furnishing.place_picture("wide picture", {room.x - 0.002, 1.6, 2.3}, -90.0, "canvas 2");
  writer.add("cupboard", "pine", cupboard({1.3, 1.9, 0.5}, 2), {{4.2, apart, room.z - 0.016}, 180.0});
}

/// Every book is an object of its own: one model, stretched.
void Room::build_books(const CaseShape& shape, const Vec3d& corner) {
  furnishing.model("book", book(0.03, 0.25, 0.18));
  for (int shelf = 0; shelf < shape.shelves; ++shelf) {
    double x = 0.035;
    const double end = shape.width - between(random, 0.05, 0.45), y = shape.level(shelf) + apart;
    while (x < end - 0.05) {
      const double thickness = between(random, 0.018, 0.052), height = between(random, 0.2, shape.room() - 0.02);
      const Vec3d scale(thickness / 0.03, height / 0.25, 0.7 * height / 0.18);
      const double front = shape.depth - between(random, 0.02, 0.05);
      furnishing.place_book("book", {corner + Vec3d(x, y, front), 0.0, scale},
                            static_cast<std::size_t>(between(random, 0.0, 5.0)));
      x += thickness + 0.0015;
      if (random.next_double() < 0.03) x += 0.12;
    }
  }
  writer.place("cup", "cup", "glaze", {corner + Vec3d(shape.width - 0.14, shape.level(3) + apart, 0.2), 200.0});
  writer.add("jar", "clay", vase(0.17, 0.04, 1.6), {corner + Vec3d(shape.width - 0.12, shape.level(1) + apart, 0.17)});
}

void Room::build_plants() {
  furnishing.model("rubber plant", leafy_plant(0.17, 1.15, 5, 11, random));
  furnishing.place_plant("rubber plant", {0.5, apart, 0.5});
  furnishing.model("grass", grassy_plant(0.12, 0.55, 46, random));
  furnishing.place_plant("grass", {0.45, apart, 4.3}, 0.0, "glaze");
  furnishing.model("herb", leafy_plant(0.06, 0.17, 4, 7, random));
  for (const double z : {1.5, 2.1, 3.15}) furnishing.place_plant("herb", {-0.02, sill + 0.03 + apart, z}, 90.0 * z);
  furnishing.place_plant("grass", {5.2, 2.13 + 2 * apart, 0.18}, 40.0, "clay");
}

void Room::build_coffee_table() {
  const Vec3d middle(3.05, 0.015, 1.75);
  const double top = 0.42 + apart;
  writer.add("coffee table", "wood", table({1.15, 0.42, 0.6}, 9), {middle});
  writer.add("teapot", "glaze", teapot(), {middle + Vec3d(0.2, top, 0.02), 35.0});
  writer.add("bowl", "clay", bowl(0.14, 0.08), {middle + Vec3d(-0.12, top, -0.08)});
  writer.model("fruit", cushion(Vec3d(0.036), 1.0, 12, 18));
  for (const auto& [x, y, z] : {std::array{0.0, 0.05, 0.05}, {0.05, 0.052, -0.02}, {-0.05, 0.052, -0.015}, {0.003, 0.105, 0.002}})
    writer.place("fruit", "fruit", y > 0.1 ? "cover 2" : "fruit", {middle + Vec3d(-0.12 + x, top + y, -0.08 + z)});
  writer.place("cup", "cup", "porcelain", {middle + Vec3d(0.36, top + 0.0105, 0.14), 10.0});
  writer.place("side plate", "side plate", "porcelain", {middle + Vec3d(0.36, top, 0.14)});
  double y = top;
  for (int i = 0; i < 4; ++i) {  // books that lie: height towards +x, spine to the front
    const Vec3d at = middle + Vec3d(-0.47 + 0.01 * i, y, 0.17 + 0.012 * i);
    Mesh cover = placed(book(0.028 - 0.003 * i, 0.26 - 0.02 * i, 0.19).cover, {0.26 - 0.02 * i, 0.0, 0.0}, {0.0, 0.0, 90.0});
    Mesh pages = placed(book(0.028 - 0.003 * i, 0.26 - 0.02 * i, 0.19).pages, {0.26 - 0.02 * i, 0.0, 0.0}, {0.0, 0.0, 90.0});
    const std::string name = "lying book " + std::to_string(i + 1);
    writer.add(name + " cover", "cover " + std::to_string(i + 1), cover, {at, 6.0 * i - 8.0});
    writer.add(name + " pages", "paper", pages, {at, 6.0 * i - 8.0});
    y += 0.028 - 0.003 * i + apart;
  }
  furnishing.model("open book", open_book(0.3, 0.21));
  furnishing.place_book("open book", {middle + Vec3d(0.1, top, 0.2), 15.0}, 0);
}

void Room::build_floor_clutter() {
  writer.model("toy block", block({-0.03, 0.0, -0.03}, {0.03, 0.06, 0.03}));
  for (int i = 0; i < 14; ++i) {
    const Vec3d at(4.3 + between(random, -0.4, 0.4), apart, 2.6 + between(random, -0.35, 0.35));
    writer.place("toy block", "toy block", "cover " + std::to_string(i % 5 + 1), {at, between(random, 0.0, 90.0)});
  }
  writer.add("ball", "cover 2", cushion(Vec3d(0.11), 1.0, 18, 28), {{4.75, 0.111, 3.1}});
  writer.add("side table", "wood", side_table(0.24, 0.5), {{5.0, apart, 1.35}});
  furnishing.place_book("open book", {{5.0, 0.5 + 2 * apart, 1.33}, 60.0}, 3);
  writer.add("basket", "pine", bowl(0.2, 0.3), {{0.4, apart, 3.75}});
  writer.model("ball of wool", cushion(Vec3d(0.06), 1.0, 10, 16));
  for (const auto& [x, y, z] : {std::array{0.06, 0.09, 0.02}, {-0.06, 0.1, 0.03}, {0.0, 0.1, -0.075}, {0.01, 0.2, 0.01}})
    writer.place("ball of wool", "ball of wool", y > 0.15 ? "cover 4" : "linen", {Vec3d(0.4, 0.0, 3.75) + Vec3d(x, y, z)});
}

Json materials() {
  return {{"plaster", diffuse(0.74, 0.70, 0.62)},    {"white", diffuse(0.80, 0.79, 0.77)},
          {"oak 1", diffuse(0.46, 0.31, 0.18)},      {"oak 2", diffuse(0.41, 0.27, 0.15)},
          {"oak 3", diffuse(0.50, 0.35, 0.21)},      {"wood", diffuse(0.28, 0.16, 0.09)},
          {"pine", diffuse(0.58, 0.43, 0.26)},       {"rug", diffuse(0.42, 0.16, 0.13)},
          {"sofa cloth", diffuse(0.30, 0.38, 0.42)}, {"armchair cloth", diffuse(0.52, 0.33, 0.12)},
          {"linen", diffuse(0.70, 0.64, 0.52)},      {"brass", diffuse(0.45, 0.34, 0.14)},
          {"shade", diffuse(0.72, 0.66, 0.54)},      {"enamel", diffuse(0.20, 0.34, 0.30)},
          {"bulb", glowing(60.0, 42.0, 24.0)},       {"porcelain", diffuse(0.80, 0.80, 0.78)},
          {"glaze", diffuse(0.14, 0.26, 0.38)},      {"clay", diffuse(0.52, 0.27, 0.16)},
          {"earth", diffuse(0.10, 0.07, 0.05)},      {"stem", diffuse(0.22, 0.26, 0.10)},
          {"leaf", diffuse(0.14, 0.30, 0.09)},       {"paper", diffuse(0.75, 0.71, 0.60)},
          {"fruit", diffuse(0.66, 0.33, 0.05)},      {"canvas 1", diffuse(0.30, 0.44, 0.56)},
          {"canvas 2", diffuse(0.62, 0.50, 0.28)},   {"canvas 3", diffuse(0.35, 0.42, 0.24)},
          {"cover 1", diffuse(0.18, 0.22, 0.36)},    {"cover 2", diffuse(0.55, 0.12, 0.09)},
          {"cover 3", diffuse(0.20, 0.34, 0.20)},    {"cover 4", diffuse(0.64, 0.52, 0.20)},
          {"cover 5", diffuse(0.36, 0.24, 0.15)}};
}

}  // namespace

std::size_t write_living_room(const std::filesystem::path& folder) {
  SceneWriter writer(folder, "living-room");
  Room living(writer);
  living.build_shell();
  living.build_window();
  living.build_seating();
  living.build_dining();
  living.build_cases();
  living.build_plants();
  living.build_coffee_table();
  living.build_floor_clutter();
  return writer.write({{"description",
                        "A furnished living room by day: sun and sky through one window, three lamps, hundreds of objects; made "
                        "by scenes/generators/."},
                       {"materials", materials()},
                       {"lights",
                        {{{"type", "directional"}, {"direction", {0.78, -0.52, -0.16}}, {"irradiance", {16.0, 14.4, 12.0}}},
                         {{"type", "environment"}, {"radiance", {1.5, 1.9, 2.6}}}}},
                       {"cameras",
                        {{{"name", "main"},
                          {"position", {6.05, 1.62, 4.5}},
                          {"look_at", {2.3, 0.95, 1.1}},
                          {"vertical_fov_degrees", 55.0},
                          {"resolution", {320, 240}}},
                         {{"name", "table"},
                          {"position", {1.6, 1.5, 2.3}},
                          {"look_at", {2.5, 0.75, 4.0}},
                          {"vertical_fov_degrees", 50.0},
                          {"resolution", {320, 240}}}}},
                       {"exposure", {{"value", 1.6}, {"start", -2.0}, {"stop", 5.0}}}});
}

}  // namespace gibench::generators
