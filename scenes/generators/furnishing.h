/// Pieces of furniture put into a scene, each part with its material.
#pragma once

#include <string>

#include "scenes/generators/furniture/books.h"
#include "scenes/generators/furniture/casework.h"
#include "scenes/generators/furniture/lamps.h"
#include "scenes/generators/furniture/plants.h"
#include "scenes/generators/furniture/seating.h"
#include "scenes/generators/scene_writer.h"

namespace gibench::generators {

/// Materials of these names must stand in the scene: "wood", "cloth", "brass", "shade", "bulb", "clay", "earth", "stem",
/// "leaf", "paper", "canvas", "cover 1" to "cover 5"; what a piece can have instead is an argument.
class Furnishing {
 public:
  explicit Furnishing(SceneWriter& writer) : writer_(writer) {}

  /// Writes the models of a piece; the place functions below put it into the scene by the same name.
  void model(const std::string& name, const Seat& seat);
  void model(const std::string& name, const Lamp& lamp);
  void model(const std::string& name, const Plant& plant);
  void model(const std::string& name, const Picture& picture);
  void model(const std::string& name, const BookRow& row);
  void model(const std::string& name, const Book& book);

  void place_seat(const std::string& name, const Vec3d& at, double turn_degrees, const std::string& cloth);
  void place_lamp(const std::string& name, const Vec3d& at, double turn_degrees = 0.0, const std::string& stand = "brass",
                  const std::string& shade = "shade");
  void place_plant(const std::string& name, const Vec3d& at, double turn_degrees = 0.0, const std::string& pot = "clay");
  void place_picture(const std::string& name, const Vec3d& at, double turn_degrees, const std::string& canvas);
  /// A row of books; the colours of the covers are shifted by `shift`.
  void place_row(const std::string& name, const Vec3d& at, double turn_degrees, std::size_t shift);
  void place_book(const std::string& name, const Placement& placement, std::size_t cover);

 private:
  SceneWriter& writer_;
};

/// A diffuse material of a scene file.
nlohmann::ordered_json diffuse(double red, double green, double blue);
/// A black surface that glows, W/(m² sr).
nlohmann::ordered_json glowing(double red, double green, double blue);

}  // namespace gibench::generators
