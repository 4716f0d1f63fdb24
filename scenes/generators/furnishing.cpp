#include "scenes/generators/furnishing.h"

namespace gibench::generators {

namespace {

constexpr Placement thin(const Vec3d& at, double turn) { return {at, turn, Vec3d(1.0), true}; }

std::string cover(std::size_t colour) { return "cover " + std::to_string(colour % cover_colours + 1); }

}  // namespace

void Furnishing::model(const std::string& name, const Seat& seat) {
  writer_.model(name + " frame", seat.frame);
  writer_.model(name + " upholstery", seat.upholstery);
}

void Furnishing::model(const std::string& name, const Lamp& lamp) {
  writer_.model(name + " stand", lamp.stand);
  if (!lamp.shade.faces.empty()) writer_.model(name + " shade", lamp.shade);
  writer_.model(name + " bulb", lamp.bulb);
}

void Furnishing::model(const std::string& name, const Plant& plant) {
  writer_.model(name + " pot", plant.pot);
  writer_.model(name + " earth", plant.earth);
  writer_.model(name + " stems", plant.stems);
  writer_.model(name + " leaves", plant.leaves);
}

void Furnishing::model(const std::string& name, const Picture& picture) {
  writer_.model(name + " frame", picture.frame);
  writer_.model(name + " canvas", picture.canvas);
}

void Furnishing::model(const std::string& name, const BookRow& row) {
  for (std::size_t i = 0; i < row.covers.size(); ++i)
    if (!row.covers[i].faces.empty()) writer_.model(name + " covers " + std::to_string(i + 1), row.covers[i]);
  writer_.model(name + " pages", row.pages);
}

void Furnishing::model(const std::string& name, const Book& book) {
  writer_.model(name + " cover", book.cover);
  writer_.model(name + " pages", book.pages);
}

void Furnishing::place_seat(const std::string& name, const Vec3d& at, double turn_degrees, const std::string& cloth) {
  writer_.place(name + " frame", name + " frame", "wood", {at, turn_degrees});
  writer_.place(name + " upholstery", name + " upholstery", cloth, {at, turn_degrees});
}

void Furnishing::place_lamp(const std::string& name, const Vec3d& at, double turn_degrees, const std::string& stand,
                            const std::string& shade) {
  writer_.place(name + " stand", name + " stand", stand, {at, turn_degrees});
  if (writer_.has_model(name + " shade")) writer_.place(name + " shade", name + " shade", shade, thin(at, turn_degrees));
  writer_.place(name + " bulb", name + " bulb", "bulb", {at, turn_degrees});
}

void Furnishing::place_plant(const std::string& name, const Vec3d& at, double turn_degrees, const std::string& pot) {
  writer_.place(name + " pot", name + " pot", pot, {at, turn_degrees});
  writer_.place(name + " earth", name + " earth", "earth", {at, turn_degrees});
  writer_.place(name + " stems", name + " stems", "stem", {at, turn_degrees});
  writer_.place(name + " leaves", name + " leaves", "leaf", thin(at, turn_degrees));
}

void Furnishing::place_picture(const std::string& name, const Vec3d& at, double turn_degrees, const std::string& canvas) {
  writer_.place(name + " frame", name + " frame", "wood", {at, turn_degrees});
  writer_.place(name + " canvas", name + " canvas", canvas, {at, turn_degrees});
}

void Furnishing::place_row(const std::string& name, const Vec3d& at, double turn_degrees, std::size_t shift) {
  for (std::size_t i = 0; i < cover_colours; ++i) {
    const std::string covers = name + " covers " + std::to_string(i + 1);
    if (writer_.has_model(covers)) writer_.place(covers, covers, cover(i + shift), {at, turn_degrees});
  }
  writer_.place(name + " pages", name + " pages", "paper", {at, turn_degrees});
}

void Furnishing::place_book(const std::string& name, const Placement& placement, std::size_t colour) {
  writer_.place(name + " cover", name + " cover", cover(colour), placement);
  writer_.place(name + " pages", name + " pages", "paper", placement);
}

nlohmann::ordered_json diffuse(double red, double green, double blue) {
  return {{"bsdf", "diffuse"}, {"albedo", {red, green, blue}}};
}

nlohmann::ordered_json glowing(double red, double green, double blue) {
  return {{"bsdf", "diffuse"}, {"albedo", 0.0}, {"emission", {red, green, blue}}};
}

}  // namespace gibench::generators
