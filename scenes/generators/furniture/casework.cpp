#include "scenes/generators/furniture/casework.h"

#include <algorithm>

namespace gibench::generators {

namespace {

constexpr double into = 0.002;  // metres by which a board reaches into another

Mesh knob(double radius) {
  return placed(lathe({{0.0, 0.0},
                       {0.5 * radius, 0.0},
                       {0.4 * radius, 0.8 * radius},
                       {radius, 1.4 * radius},
                       {0.9 * radius, 1.9 * radius},
                       {0.5 * radius, 2.2 * radius},
                       {0.0, 2.3 * radius}},
                      14),
                Vec3d(0.0), {90.0, 0.0, 0.0});
}

Mesh leg(double height, double radius, int columns) {
  return lathe({{0.0, 0.0},
                {0.6 * radius, 0.0},
                {0.8 * radius, 0.03 * height},
                {0.6 * radius, 0.06 * height},
                {0.75 * radius, 0.4 * height},
                {1.05 * radius, 0.7 * height},
                {0.8 * radius, 0.74 * height},
                {1.1 * radius, 0.77 * height},
                {1.1 * radius, 0.8 * height},
                {0.9 * radius, 0.82 * height},
                {radius, height},
                {0.0, height}},
               columns);
}

/// Four bars round an opening of that size, about the origin in the x-y plane, from z = 0 to `depth`.
Mesh bars(double width, double height, double bar, double depth) {
  const double x = 0.5 * width, y = 0.5 * height;
  Mesh mesh = block({-x - bar, -y - bar, 0.0}, {-x, y + bar, depth});
  mesh.append(block({x, -y - bar, 0.0}, {x + bar, y + bar, depth}));
  mesh.append(block({-x - into, y, into}, {x + into, y + bar - into, depth - into}));
  mesh.append(block({-x - into, -y - bar + into, into}, {x + into, -y, depth - into}));
  return mesh;
}

}  // namespace

Mesh table(const Vec3d& size, int columns) {
  const double x = 0.5 * size.x, z = 0.5 * size.z, top = size.y - 0.035, inset = 0.09;
  Mesh mesh = placed(cushion({x, 0.0175, z}, 0.15, 8, 40), {0.0, top + 0.0175, 0.0});
  for (const double side : {-1.0, 1.0}) {
    mesh.append(block({-x + inset, top - 0.09, side * (z - inset) - 0.011}, {x - inset, top + into, side * (z - inset) + 0.011}));
    mesh.append(
        block({side * (x - inset) - 0.011, top - 0.088, -z + inset}, {side * (x - inset) + 0.011, top + into, z - inset}));
    for (const double end : {-1.0, 1.0})
      mesh.append(placed(leg(top + into, 0.035, columns), {side * (x - inset), 0.0, end * (z - inset)}));
  }
  return mesh;
}

Mesh side_table(double radius, double height) {
  Mesh mesh = lathe({{0.0, height - 0.025},
                     {radius - 0.01, height - 0.025},
                     {radius, height - 0.018},
                     {radius, height - 0.006},
                     {radius - 0.008, height},
                     {0.0, height}},
                    36);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * pi_double * (i + 0.2) / 3.0, x = std::cos(angle), z = std::sin(angle);
    mesh.append(pipe({{0.85 * radius * x, 0.0, 0.85 * radius * z}, {0.6 * radius * x, height - 0.02, 0.6 * radius * z}}, 14,
                     [](double t) { return 0.011 + 0.008 * t; }));
  }
  return mesh;
}

double CaseShape::level(int shelf) const { return plinth + board + shelf * (room() + board); }
double CaseShape::room() const { return (height - plinth - board) / shelves - board; }

Mesh bookcase(const CaseShape& shape) {
  const double side = 0.026;
  Mesh mesh = block({0.0, 0.0, 0.0}, {side, shape.height, shape.depth});
  mesh.append(block({shape.width - side, 0.0, 0.0}, {shape.width, shape.height, shape.depth}));
  mesh.append(block({side - into, 0.03, 0.004}, {shape.width - side + into, shape.height - 0.01, 0.012}));  // the back
  for (int shelf = 0; shelf < shape.shelves; ++shelf)
    mesh.append(block({side - into, shape.level(shelf) - shape.board, 0.01},
                      {shape.width - side + into, shape.level(shelf), shape.depth - 0.006}));
  mesh.append(block({side - into, shape.height - shape.board, 0.01},
                    {shape.width - side + into, shape.height - 0.002, shape.depth - 0.002}));
  mesh.append(
      block({side - into, 0.0, shape.depth - 0.04}, {shape.width - side + into, shape.plinth + into, shape.depth - 0.02}));
  mesh.append(
      block({-0.015, shape.height - into, -0.0}, {shape.width + 0.015, shape.height + 0.03, shape.depth + 0.02}));  // cornice
  return mesh;
}

Mesh cupboard(const Vec3d& size, int doors) {
  Mesh mesh = block({0.0, 0.05, 0.0}, {size.x, size.y - 0.025, size.z});
  mesh.append(block({0.03, 0.0, 0.02}, {size.x - 0.03, 0.05 + into, size.z - 0.04}));
  mesh.append(block({-0.02, size.y - 0.025 - into, 0.0}, {size.x + 0.02, size.y, size.z + 0.025}));
  const double width = size.x / doors;
  for (int i = 0; i < doors; ++i) {
    const double left = width * i + 0.006, right = width * (i + 1) - 0.006, front = size.z + 0.018;
    mesh.append(block({left, 0.07, size.z + 0.002}, {right, size.y - 0.04, front}));
    mesh.append(placed(bars(right - left - 0.14, size.y - 0.25, 0.03, 0.008),
                       {0.5 * (left + right), 0.5 * (size.y + 0.03), front - into}));
    mesh.append(placed(knob(0.013), {i % 2 == 0 ? right - 0.035 : left + 0.035, 0.6 * size.y, front - into}));
  }
  return mesh;
}

Mesh panelled_door(double width, double height) {
  Mesh mesh = block({0.0, 0.0, 0.0}, {width, height, 0.04});
  for (const double x : {0.27, 0.73})
    for (const auto& [y, share] : {std::array{0.25, 0.34}, {0.7, 0.44}})
      mesh.append(placed(bars(0.28 * width, share * height - 0.12, 0.022, 0.012), {x * width, y * height, 0.04 - into}));
  mesh.append(placed(knob(0.022), {width - 0.06, 0.48 * height, 0.04 - into}));
  for (const double y : {0.1, 0.5, 0.9})
    mesh.append(placed(lathe({{0.0, -0.04}, {0.008, -0.04}, {0.008, 0.04}, {0.0, 0.04}}, 10), {-0.006, y * height, 0.04}));
  return mesh;
}

Mesh ladder(double width, double height, double lean, int rungs) {
  Mesh mesh;
  for (const double x : {0.0, width})
    mesh.append(pipe({{x, 0.0, lean}, {x, 0.5 * height, 0.5 * lean}, {x, height, 0.0}}, 14, 0.02));
  for (int i = 1; i <= rungs; ++i) {
    const double t = static_cast<double>(i) / (rungs + 1), y = t * height, z = lean * (1.0 - t);
    mesh.append(pipe({{0.0, y, z}, {width, y, z}}, 14, 0.014));
  }
  return mesh;
}

Mesh radiator(double width, double height) {
  const int ribs = static_cast<int>(width / 0.06);
  Mesh mesh;
  for (int i = 0; i < ribs; ++i)
    mesh.append(placed(cushion({0.022, 0.5 * height, 0.055}, 0.3, 6, 10), {0.06 * (i + 0.5), 0.5 * height + 0.1, 0.07}));
  for (const double y : {0.16, height + 0.04}) mesh.append(pipe({{0.02, y, 0.07}, {width - 0.02, y, 0.07}}, 12, 0.016));
  mesh.append(pipe({{width - 0.04, 0.16, 0.07}, {width - 0.04, 0.0, 0.07}}, 12, 0.012));
  return mesh;
}

Picture picture(double width, double height) {
  return {bars(width, height, 0.045, 0.028),
          block({-0.5 * width - into, -0.5 * height - into, into}, {0.5 * width + into, 0.5 * height + into, 0.012})};
}

}  // namespace gibench::generators
