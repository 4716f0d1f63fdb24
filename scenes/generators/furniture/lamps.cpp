#include "scenes/generators/furniture/lamps.h"

#include <cmath>

namespace gibench::generators {

namespace {

/// A cone without its ends, facing outwards, about the y axis.
Mesh cone(double low_radius, double high_radius, double low, double high, int rows, int columns) {
  return sheet(rows, columns, [&](double u, double v) {
    const double angle = 2.0 * pi_double * u, radius = low_radius + (high_radius - low_radius) * v;
    return Vec3d(radius * std::cos(angle), low + (high - low) * v, -radius * std::sin(angle));
  });
}

/// The ends of a closed round are the same points.
Mesh joined_round(Mesh mesh, int columns) {
  const auto row = static_cast<std::uint32_t>(columns + 1);
  for (auto& face : mesh.faces)
    for (std::uint32_t& corner : face)
      if (corner % row == row - 1) corner -= row - 1;
  Mesh result;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (i % row != row - 1) result.vertices.push_back(mesh.vertices[i]);
  for (auto face : mesh.faces) {
    for (std::uint32_t& corner : face) corner -= corner / row;
    result.faces.push_back(face);
  }
  return result;
}

Mesh round_shade(double low_radius, double high_radius, double low, double high) {
  constexpr int columns = 32;
  return joined_round(cone(low_radius, high_radius, low, high, 6, columns), columns);
}

Mesh globe(double radius, const Vec3d& centre, int rows = 8, int columns = 14) {
  return placed(cushion(Vec3d(radius), 1.0, rows, columns), centre);
}

}  // namespace

Lamp floor_lamp(double height) {
  Lamp lamp;
  lamp.stand = lathe({{0.0, 0.0},
                      {0.15, 0.0},
                      {0.155, 0.012},
                      {0.14, 0.022},
                      {0.03, 0.03},
                      {0.013, 0.05},
                      {0.011, height - 0.12},
                      {0.0, height - 0.12}},
                     28);
  lamp.shade = round_shade(0.22, 0.15, height - 0.16, height + 0.16);
  lamp.bulb = globe(0.05, {0.0, height - 0.06, 0.0});
  return lamp;
}

Lamp table_lamp() {
  Lamp lamp;
  lamp.stand = lathe({{0.0, 0.0},
                      {0.07, 0.0},
                      {0.072, 0.012},
                      {0.05, 0.02},
                      {0.06, 0.04},
                      {0.085, 0.09},
                      {0.09, 0.13},
                      {0.075, 0.18},
                      {0.04, 0.22},
                      {0.018, 0.24},
                      {0.012, 0.26},
                      {0.012, 0.33},
                      {0.0, 0.33}},
                     26);
  lamp.shade = round_shade(0.17, 0.10, 0.29, 0.50);
  lamp.bulb = globe(0.035, {0.0, 0.365, 0.0});
  return lamp;
}

Lamp reading_lamp() {
  Lamp lamp;
  lamp.stand = lathe({{0.0, 0.0},
                      {0.09, 0.0},
                      {0.092, 0.01},
                      {0.07, 0.022},
                      {0.02, 0.035},
                      {0.016, 0.06},
                      {0.010, 0.1},
                      {0.009, 0.34},
                      {0.016, 0.36},
                      {0.012, 0.40},
                      {0.0, 0.40}},
                     24);
  // Half a barrel over the bulb, open below.
  lamp.shade = sheet(14, 10, [](double u, double v) {
    const double angle = pi_double * v, x = 0.16 * (2.0 * u - 1.0), belly = 1.0 - 0.25 * std::pow(2.0 * u - 1.0, 2.0);
    return Vec3d(x, 0.33 + 0.09 * belly * std::sin(angle), 0.085 * belly * std::cos(angle));
  });
  lamp.bulb = pipe({{-0.11, 0.375, 0.0}, {0.11, 0.375, 0.0}}, 10, 0.018);
  return lamp;
}

Lamp pendant(double drop, double radius) {
  Lamp lamp;
  lamp.stand = lathe({{0.0, -drop},
                      {0.03, -drop},
                      {0.03, -drop + 0.07},
                      {0.004, -drop + 0.09},
                      {0.004, -0.03},
                      {0.05, -0.02},
                      {0.05, -0.002},
                      {0.0, -0.002}},
                     18);
  constexpr int columns = 40;
  lamp.shade = joined_round(sheet(8, columns,
                                  [&](double u, double v) {
                                    const double angle = 2.0 * pi_double * u, latitude = 0.08 + 1.42 * v;
                                    const double ring = radius * std::cos(latitude);
                                    return Vec3d(ring * std::cos(angle), -drop - 0.04 + 0.55 * radius * std::sin(latitude),
                                                 -ring * std::sin(angle));
                                  }),
                            columns);
  lamp.bulb = globe(0.055, {0.0, -drop - 0.05, 0.0});
  return lamp;
}

Lamp chandelier(double drop, double radius, int arms) {
  Lamp lamp;
  lamp.stand = lathe({{0.0, -drop - 0.2},
                      {0.02, -drop - 0.19},
                      {0.06, -drop - 0.12},
                      {0.03, -drop - 0.05},
                      {0.1, -drop},
                      {0.11, -drop + 0.05},
                      {0.04, -drop + 0.1},
                      {0.05, -drop + 0.3},
                      {0.012, -drop + 0.36},
                      {0.012, -0.06},
                      {0.07, -0.04},
                      {0.07, -0.003},
                      {0.0, -0.003}},
                     24);
  for (int i = 0; i < arms; ++i) {
    const double turn = 360.0 * i / arms;
    const auto bent = [&](double t) {
      return Vec3d(0.06 + (radius - 0.06) * t, -drop + 0.02 - 0.22 * std::sin(pi_double * std::pow(t, 0.8)) + 0.1 * t * t, 0.0);
    };
    std::vector<Vec3d> points;
    for (int step = 0; step <= 16; ++step) points.push_back(bent(step / 16.0));
    Mesh arm = pipe(points, 12, [](double t) { return 0.014 - 0.005 * t; });
    const double y = points.back().y;
    arm.append(
        placed(lathe({{0.0, -0.01}, {0.02, -0.005}, {0.055, 0.012}, {0.05, 0.016}, {0.018, 0.012}, {0.016, 0.1}, {0.0, 0.1}}, 18),
               {radius, y, 0.0}));
    lamp.stand.append(placed(arm, Vec3d(0.0), {0.0, turn, 0.0}));
    lamp.bulb.append(
        placed(placed(cushion({0.018, 0.045, 0.018}, 1.0, 8, 10), {radius, y + 0.147, 0.0}), Vec3d(0.0), {0.0, turn, 0.0}));
  }
  return lamp;
}

}  // namespace gibench::generators
