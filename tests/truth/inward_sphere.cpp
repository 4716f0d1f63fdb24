#include "inward_sphere.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/vec.h"

namespace gibench::truth {

nlohmann::json inward_sphere(const nlohmann::json& sphere) {
  using nlohmann::json;
  const int rows = sphere.at("rows").get<int>(), columns = sphere.at("columns").get<int>();
  const double polar_step = pi_double / rows, around_step = 2.0 * pi_double / columns;
  // A chord of angle a sags by a²/8 of the radius at its middle, by two thirds of that in the mean.
  const double sag = (polar_step * polar_step + around_step * around_step * 0.5) / 12.0;
  const double radius = sphere.at("radius").get<double>() * (1.0 + sag);
  json vertices = json::array(), faces = json::array();
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double polar = row * polar_step, around = column * around_step;
      vertices.push_back(
          {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around), radius * std::cos(polar)});
    }
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int next = (column + 1) % columns;
      const int above = row * columns, below = (row + 1) * columns;
      if (row > 0) faces.push_back({above + column, above + next, below + next});
      if (row < rows - 1) faces.push_back({above + column, below + next, below + column});
    }
  return {{"name", sphere.at("name")}, {"material", sphere.at("material")}, {"vertices", vertices}, {"faces", faces}};
}

}  // namespace gibench::truth
