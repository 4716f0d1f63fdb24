#include "scenes/generators/furniture/plants.h"

#include <cmath>

namespace gibench::generators {

namespace {

double pot_height(double radius) { return 1.7 * radius; }

Plant potted(double radius) {
  const double height = pot_height(radius);
  Plant plant;
  plant.pot = lathe({{0.0, 0.0},
                     {0.68 * radius, 0.0},
                     {0.95 * radius, 0.86 * height},
                     {1.06 * radius, 0.87 * height},
                     {1.08 * radius, height},
                     {0.96 * radius, height},
                     {0.82 * radius, 0.5 * height},
                     {0.0, 0.5 * height}},
                    32);
  plant.earth = lathe({{0.0, 0.55 * height},
                       {0.80 * radius, 0.56 * height},
                       {0.89 * radius, 0.85 * height},
                       {0.5 * radius, 0.89 * height},
                       {0.0, 0.9 * height}},
                      24);
  return plant;
}

/// A leaf along a curve from `base`: it starts out in direction `out` and `up` and droops; `width` metres at its widest.
Mesh leaf(const Vec3d& base, const Vec3d& out, double up, double length, double droop, double width, int steps) {
  const Vec3d side = glm::normalize(glm::cross(Vec3d(0, 1, 0), out));
  return sheet(steps, 2, [&](double u, double v) {
    const double across = 2.0 * u - 1.0,
                 half = 0.5 * width * std::pow(std::sin(pi_double * std::min(0.97, 0.06 + 0.91 * v)), 0.8);
    const Vec3d spine = base + length * (v * out + Vec3d(0.0, up * v - droop * v * v, 0.0));
    return spine + across * half * side + Vec3d(0.0, 0.25 * half * std::abs(across), 0.0);
  });
}

Vec3d heading(double angle) { return {std::cos(angle), 0.0, std::sin(angle)}; }

}  // namespace

Plant grassy_plant(double pot_radius, double height, int leaves, RandomStream& random) {
  Plant plant = potted(pot_radius);
  const double foot = 0.9 * pot_height(pot_radius);
  plant.stems = placed(cushion({0.3 * pot_radius, 0.04, 0.3 * pot_radius}, 1.0, 8, 14), {0.0, foot, 0.0});
  for (int i = 0; i < leaves; ++i) {
    const double angle = 2.4 * i + between(random, -0.3, 0.3), outward = between(random, 0.25, 1.0);
    const Vec3d out = heading(angle), base = Vec3d(0.0, foot + 0.02, 0.0) + 0.22 * pot_radius * out;
    plant.leaves.append(leaf(base, outward * out, between(random, 1.1, 1.8), 0.75 * height, between(random, 0.5, 1.0),
                             between(random, 0.02, 0.04), 7));
  }
  return plant;
}

Plant leafy_plant(double pot_radius, double height, int stems, int leaves_per_stem, RandomStream& random) {
  Plant plant = potted(pot_radius);
  const double foot = 0.88 * pot_height(pot_radius);
  for (int stem = 0; stem < stems; ++stem) {
    const double angle = 2.0 * pi_double * (stem + between(random, 0.0, 0.6)) / stems, tall = height * between(random, 0.75, 1.1);
    const Vec3d out = heading(angle), base = Vec3d(0.0, foot, 0.0) + 0.25 * pot_radius * out;
    const auto along = [&](double t) { return base + Vec3d(0.0, tall * t, 0.0) + (0.28 * tall * t * t) * out; };
    std::vector<Vec3d> points;
    for (int i = 0; i <= 8; ++i) points.push_back(along(i / 8.0));
    plant.stems.append(pipe(points, 6, [](double t) { return 0.009 - 0.006 * t; }));
    for (int i = 0; i < leaves_per_stem; ++i) {
      const double t = 0.3 + 0.7 * (i + 0.5) / leaves_per_stem, size = between(random, 0.10, 0.19);
      const Vec3d away = heading(2.4 * i + angle + between(random, -0.4, 0.4)), start = along(t) + 0.012 * away;
      plant.leaves.append(leaf(start, away, between(random, 0.3, 0.8), size, between(random, 0.5, 1.1), 0.6 * size, 4));
    }
  }
  return plant;
}

}  // namespace gibench::generators
