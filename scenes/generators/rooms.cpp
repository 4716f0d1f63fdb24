#include "scenes/generators/rooms.h"

#include <algorithm>
#include <cmath>

namespace gibench::generators {

namespace {

std::vector<double> cuts(double end, const std::vector<Opening>& openings, double Opening::*low, double Opening::*high) {
  std::vector<double> result{0.0, end};
  for (const Opening& opening : openings) {
    result.push_back(opening.*low);
    result.push_back(opening.*high);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// The four sides of the hole, facing into it.
Mesh reveal(const Opening& o, double depth) {
  Mesh mesh;
  for (const double z : {0.0, -depth})
    for (const auto& [x, y] : {std::array{o.left, o.low}, {o.right, o.low}, {o.right, o.high}, {o.left, o.high}})
      mesh.vertices.push_back({x, y, z});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    mesh.faces.push_back({i, next, 4 + next, 4 + i});
  }
  return mesh;
}

}  // namespace

Mesh wall(double width, double height, const std::vector<Opening>& openings, double depth) {
  const std::vector<double> xs = cuts(width, openings, &Opening::left, &Opening::right);
  const std::vector<double> ys = cuts(height, openings, &Opening::low, &Opening::high);
  Mesh mesh;
  for (const double y : ys)
    for (const double x : xs) mesh.vertices.push_back({x, y, 0.0});
  const auto at = [&](std::size_t row, std::size_t column) { return static_cast<std::uint32_t>(row * xs.size() + column); };
  for (std::size_t row = 0; row + 1 < ys.size(); ++row)
    for (std::size_t column = 0; column + 1 < xs.size(); ++column) {
      const double x = 0.5 * (xs[column] + xs[column + 1]), y = 0.5 * (ys[row] + ys[row + 1]);
      const auto holds = [&](const Opening& o) { return x > o.left && x < o.right && y > o.low && y < o.high; };
      if (std::any_of(openings.begin(), openings.end(), holds)) continue;
      mesh.faces.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)});
    }
  for (const Opening& opening : openings) mesh.append(reveal(opening, depth));
  return mesh;
}

Mesh window_bars(const Opening& o, int columns, int rows, double bar, double back) {
  const double half = 0.5 * bar, apart = 0.001;
  Mesh mesh;
  for (int i = 0; i <= columns; ++i) {
    const double middle = std::clamp(o.left + (o.right - o.left) * i / columns, o.left + half + apart, o.right - half - apart);
    mesh.append(block({middle - half, o.low + apart, -back - half}, {middle + half, o.high - apart, -back + half}));
  }
  for (int i = 0; i <= rows; ++i) {
    const double middle = std::clamp(o.low + (o.high - o.low) * i / rows, o.low + half + 2 * apart, o.high - half - 2 * apart);
    mesh.append(
        block({o.left + 2 * apart, middle - half, -back - 0.4 * bar}, {o.right - 2 * apart, middle + half, -back + 0.4 * bar}));
  }
  return mesh;
}

Mesh curtain(double width, double height, int folds, RandomStream& random) {
  const double phase = between(random, 0.0, 6.0), skew = between(random, 0.1, 0.3);
  return sheet(10, 8 * folds, [&](double u, double v) {
    const double loose = 1.0 - 0.55 * v, angle = 2.0 * pi_double * folds * u + phase;
    const double depth = 0.045 * loose * std::sin(angle) + 0.012 * loose * std::sin(0.37 * angle + 5.0 * v);
    return Vec3d(width * (u + 0.06 * (u - 0.5) * (1.0 - v) + 0.25 / folds * skew * loose * std::sin(0.5 * angle)), height * v,
                 depth);
  });
}

Mesh skirting(double width) {
  Mesh mesh = block({0.0, 0.001, 0.001}, {width, 0.07, 0.014});
  mesh.append(block({0.0, 0.069, 0.001}, {width, 0.085, 0.010}));
  return mesh;
}

Floorboards floorboards(double width, double depth, double board_width, RandomStream& random) {
  constexpr double gap = 0.001, thickness = 0.012;  // metres
  Floorboards result;
  const int rows = static_cast<int>(std::ceil(depth / board_width));
  for (int row = 0; row < rows; ++row) {
    const double low = row * depth / rows + gap, high = (row + 1) * depth / rows;
    for (double x = gap; x < width;) {
      double end = std::min(width, x + between(random, 0.7, 2.2));
      if (width - end < 0.3) end = width;
      const auto tone = static_cast<std::size_t>(random.next_double() * 3.0);
      result.tones[tone].append(block({x, -thickness, low}, {end - gap, 0.0, high}));
      x = end;
    }
  }
  constexpr double past = 0.002;
  result.under = sheet(1, 1, [&](double u, double v) {
    return Vec3d(-past + v * (width + 2 * past), -thickness - gap, -past + u * (depth + 2 * past));
  });
  return result;
}

Mesh room_walls(const Vec3d& size, const std::array<std::vector<Opening>, 4>& openings, double reveal) {
  constexpr double past = 0.002, below = 0.03;
  Mesh result;
  const auto add = [&](std::size_t side, double width, const Vec3d& corner, double turn) {
    std::vector<Opening> moved = openings[side];
    for (Opening& o : moved) o = {o.left + past, o.low + below, o.right + past, o.high + below};
    const Mesh raised = placed(wall(width + 2 * past, size.y + below + past, moved, reveal), {-past, -below, 0.0});
    result.append(placed(raised, corner, {0.0, turn, 0.0}));
  };
  add(0, size.x, {0, 0, 0}, 0.0);
  add(1, size.z, {0, 0, size.z}, 90.0);
  add(2, size.x, {size.x, 0, size.z}, 180.0);
  add(3, size.z, {size.x, 0, 0}, -90.0);
  return result;
}

Mesh room_ceiling(const Vec3d& size, const std::vector<Opening>& openings, double reveal) {
  constexpr double past = 0.002;
  std::vector<Opening> moved = openings;
  for (Opening& o : moved) o = {o.left + past, o.low + past, o.right + past, o.high + past};
  const Mesh flat = wall(size.x + 2 * past, size.z + 2 * past, moved, reveal);
  return placed(placed(flat, {-past, -past, 0.0}), {0.0, size.y, 0.0}, {90.0, 0.0, 0.0});
}

}  // namespace gibench::generators
