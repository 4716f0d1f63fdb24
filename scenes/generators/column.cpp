#include "scenes/generators/column.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gibench::generators {

namespace {

constexpr double plinth_height = 0.16, abacus_height = 0.14, overlap = 0.004;  // metres
constexpr double flute_depth = 0.09;                                           // of the radius

/// One ring of the turned part.
struct Ring {
  double y, radius;  ///< metres
  double fluting;    ///< share of the full flute depth, [0, 1]
};

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// A half-round moulding from y_low to y_high that stands out from `radius` by half its height.
void add_torus(std::vector<Ring>& rings, double y_low, double y_high, double radius, int rows) {
  for (int i = 0; i <= rows; ++i) {
    const double angle = pi_double * i / rows, half = 0.5 * (y_high - y_low);
    rings.push_back({y_low + half * (1.0 - std::cos(angle)), radius + half * std::sin(angle), 0.0});
  }
}

/// The diameter shrinks slowly at first and faster above: the convex curve called entasis.
void add_shaft(std::vector<Ring>& rings, const ColumnShape& shape, double y_low, double y_high) {
  for (int i = 0; i <= shape.shaft_rows; ++i) {
    const double t = static_cast<double>(i) / shape.shaft_rows;
    const double radius = shape.lower_radius + (shape.upper_radius - shape.lower_radius) * std::pow(t, 1.7);
    rings.push_back({y_low + t * (y_high - y_low), radius, smoothstep(0.0, 0.06, t) * smoothstep(0.0, 0.05, 1.0 - t)});
  }
}

/// The cushion of the capital: a quarter of an ellipse that swells from the neck to the abacus.
void add_echinus(std::vector<Ring>& rings, double y_low, double y_high, double neck_radius, double rim_radius) {
  constexpr int rows = 7;
  for (int i = 0; i <= rows; ++i) {
    const double angle = 0.5 * pi_double * i / rows;
    rings.push_back(
        {y_low + (y_high - y_low) * (1.0 - std::cos(angle)), neck_radius + (rim_radius - neck_radius) * std::sin(angle), 0.0});
  }
}

}  // namespace

Mesh column(const ColumnShape& shape) {
  const double r = shape.lower_radius, base = plinth_height, top = shape.height - abacus_height;
  std::vector<Ring> rings;
  add_torus(rings, base - overlap, base + 0.12, 1.12 * r, 7);
  add_torus(rings, base + 0.15, base + 0.22, 1.02 * r, 5);
  add_shaft(rings, shape, base + 0.25, top - 0.30);
  add_torus(rings, top - 0.27, top - 0.23, 1.01 * shape.upper_radius, 4);
  add_echinus(rings, top - 0.20, top + overlap, 0.98 * shape.upper_radius, 1.35 * r);

  const int rows = static_cast<int>(rings.size()) + 1;
  Mesh mesh = closed_grid(rows, shape.flutes * shape.points_per_flute, [&](double row, double angle) {
    const auto index = static_cast<std::size_t>(std::lround(row * rows));
    if (index == 0) return Vec3d(0.0, rings.front().y, 0.0);
    if (index > rings.size()) return Vec3d(0.0, rings.back().y, 0.0);
    const Ring& ring = rings[index - 1];
    const double flute = std::abs(std::sin(0.5 * shape.flutes * angle));
    const double radius = ring.radius * (1.0 - flute_depth * ring.fluting * flute);
    return Vec3d(radius * std::cos(angle), ring.y, -radius * std::sin(angle));
  });
  const double plinth = 1.5 * r, abacus = 1.45 * r;
  mesh.append(block({-plinth, 0.0, -plinth}, {plinth, plinth_height, plinth}));
  mesh.append(block({-abacus, top, -abacus}, {abacus, shape.height, abacus}));
  return mesh;
}

}  // namespace gibench::generators
