#include "scenes/generators/furniture/seating.h"

#include <array>
#include <cmath>

namespace gibench::generators {

namespace {

/// A turned leg with two rings, from y = 0 to `height`.
Mesh turned_leg(double height, double radius, int columns) {
  std::vector<ProfilePoint> profile{{0.0, 0.0}};
  for (const auto& [share, y] : std::array<std::array<double, 2>, 13>{{{0.55, 0.0},
                                                                       {0.7, 0.02},
                                                                       {0.6, 0.06},
                                                                       {0.75, 0.3},
                                                                       {1.1, 0.33},
                                                                       {1.1, 0.36},
                                                                       {0.75, 0.39},
                                                                       {0.95, 0.7},
                                                                       {1.2, 0.73},
                                                                       {1.2, 0.76},
                                                                       {0.9, 0.79},
                                                                       {1.0, 0.9},
                                                                       {1.0, 1.0}}})
    profile.push_back({share * radius, y * height});
  profile.push_back({0.0, height});
  return lathe(profile, columns);
}

/// A board bent about the sitter: along x, its middle `bend` metres behind its ends.
Mesh bent_rail(double width, double height, double thickness, double bend) {
  return closed_grid(8, 28, [&](double row, double angle) {
    const double latitude = pi_double * (row - 0.5), ring = std::pow(std::max(0.0, std::cos(latitude)), 0.4);
    const auto power = [](double x, double exponent) { return std::copysign(std::pow(std::abs(x), exponent), x); };
    const double x = 0.5 * width * ring * power(std::cos(angle), 0.5), t = 2.0 * x / width;
    return Vec3d(x, 0.5 * height * power(std::sin(latitude), 0.5),
                 -0.5 * thickness * ring * power(std::sin(angle), 0.5) - bend * (1.0 - t * t));
  });
}

}  // namespace

Seat chair(int columns) {
  constexpr double seat = 0.45, half = 0.2, back_lean = 0.10, back_top = 0.93;  // metres
  Seat result;
  Mesh& frame = result.frame;
  for (const double x : {-1.0, 1.0}) {
    frame.append(placed(turned_leg(seat, 0.02, columns), {x * half, 0.0, 0.19}));
    frame.append(pipe({{x * (half - 0.01), 0.0, -0.21},
                       {x * (half - 0.01), 0.25, -0.19},
                       {x * (half - 0.01), seat, -0.19},
                       {x * (half - 0.01), 0.7, -0.22},
                       {x * (half - 0.01), back_top, -0.19 - back_lean}},
                      columns, [](double t) { return 0.014 + 0.006 * std::sin(pi_double * t); }));
    frame.append(pipe({{x * half, 0.17, 0.19}, {x * (half - 0.01), 0.17, -0.195}}, columns, 0.01));
  }
  for (const auto& [y, z] : {std::array{0.24, 0.19}, {0.24, -0.19}})
    frame.append(pipe({{-half + 0.005, y, z}, {half - 0.005, y, z}}, columns, 0.01));
  frame.append(placed(cushion({half + 0.03, 0.014, 0.225}, 0.3, 8, 32), {0.0, seat, 0.0}));
  for (int i = 0; i < 5; ++i) {
    const double x = 0.068 * (i - 2);
    frame.append(pipe({{x, seat, -0.185}, {x, 0.68, -0.225}, {x, back_top - 0.02, -0.21 - back_lean}}, columns, 0.007));
  }
  frame.append(placed(bent_rail(0.44, 0.09, 0.022, 0.025), {0.0, back_top - 0.02, -0.185 - back_lean}, {-15.0, 0.0, 0.0}));
  result.upholstery = placed(cushion({half + 0.005, 0.022, 0.195}, 0.45, 10, 32), {0.0, seat + 0.038, 0.01});
  return result;
}

Seat sofa(int places) {
  const double inner = 0.78 * places, half = 0.5 * inner + 0.2;
  Seat result;
  for (const double x : {-half + 0.12, half - 0.12})
    for (const double z : {-0.36, 0.36}) result.frame.append(placed(turned_leg(0.14, 0.028, 9), {x, 0.0, z}));
  Mesh& soft = result.upholstery;
  soft.append(placed(cushion({half - 0.02, 0.13, 0.44}, 0.12, 8, 24), {0.0, 0.25, 0.0}));
  soft.append(placed(cushion({half - 0.03, 0.31, 0.11}, 0.25, 9, 24), {0.0, 0.57, -0.36}, {-6.0, 0.0, 0.0}));
  for (const double side : {-1.0, 1.0})
    soft.append(placed(cushion({0.11, 0.2, 0.45}, 0.35, 9, 24), {side * (half - 0.1), 0.46, 0.01}));
  for (int i = 0; i < places; ++i) {
    const double x = -0.5 * inner + 0.78 * (i + 0.5);
    soft.append(placed(cushion({0.385, 0.075, 0.33}, 0.35, 9, 24), {x, 0.452, 0.12}));
    soft.append(placed(cushion({0.37, 0.20, 0.085}, 0.4, 9, 24), {x, 0.735, -0.18}, {-10.0, 0.0, 0.0}));
  }
  return result;
}

Mesh pillow(double size) {
  return closed_grid(14, 32, [&](double row, double angle) {
    // An ellipsoid about z, squared in its plane and drawn out into four corners.
    const double latitude = pi_double * (row - 0.5), ring = std::cos(latitude);
    const double c = std::cos(angle), s = std::sin(angle),
                 square = std::pow(std::pow(std::abs(c), 5.0) + std::pow(std::abs(s), 5.0), -0.2);
    const double out = 0.5 * size * std::pow(ring, 0.6) * square * (1.0 - 0.06 * (1.0 - std::abs(std::sin(2.0 * angle))));
    return Vec3d(out * c, out * s, 0.18 * size * std::sin(latitude) * (0.4 + 0.6 * ring));
  });
}

}  // namespace gibench::generators
