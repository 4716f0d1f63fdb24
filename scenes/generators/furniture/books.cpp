#include "scenes/generators/furniture/books.h"

#include <algorithm>
#include <cmath>

namespace gibench::generators {

namespace {

constexpr double board = 0.003, gap = 0.001, apart = 0.0015;  // metres

/// A prism over a cover's section in the x-z plane: two boards and the spine that joins them, open at the back.
Mesh cover_prism(double thickness, double height, double depth) {
  const double inner = thickness - board;
  const std::array<std::array<double, 2>, 8> section{{{0, -depth},
                                                      {0, 0},
                                                      {thickness, 0},
                                                      {thickness, -depth},
                                                      {inner, -depth},
                                                      {inner, -board},
                                                      {board, -board},
                                                      {board, -depth}}};
  Mesh mesh;
  for (const double y : {0.0, height})
    for (const auto& [x, z] : section) mesh.vertices.push_back({x, y, z});
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t next = (i + 1) % 8;
    mesh.faces.push_back({i, next, 8 + next, 8 + i});
  }
  for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 1, 6, 7}, {1, 2, 5, 6}, {2, 3, 4, 5}}) {
    mesh.faces.push_back({d, c, b, a});
    mesh.faces.push_back({8 + a, 8 + b, 8 + c, 8 + d});
  }
  return mesh;
}

struct Size {
  double thickness, height, depth;  // metres
};

Size draw_size(double room, double thickness, RandomStream& random) {
  const double height = std::min(room - 0.015, between(random, 0.19, 0.31));
  return {thickness * between(random, 0.55, 1.6), height, height * between(random, 0.66, 0.76)};
}

void put(BookRow& row, const Book& book, std::size_t colour, const Vec3d& at, const Vec3d& turn) {
  row.covers[colour].append(placed(book.cover, at, turn));
  row.pages.append(placed(book.pages, at, turn));
}

/// Three to five books lying on one another; the length that they take.
double add_pile(BookRow& row, double x, double room, double thickness, RandomStream& random) {
  double y = apart, longest = 0.0;
  const int count = 3 + static_cast<int>(random.next_double() * 3.0);
  for (int i = 0; i < count; ++i) {
    const Size size = draw_size(room, thickness, random);
    if (y + size.thickness > room - 0.02) break;
    const auto colour = static_cast<std::size_t>(random.next_double() * cover_colours);
    // Lying on its back board, spine forward: the thickness goes up and the height along x.
    const double z = -between(random, 0.0, 0.03), turn = between(random, -3.0, 3.0);
    put(row, book(size.thickness, size.height, size.depth), colour, {x + size.height + 0.01, y, z}, {0.0, turn, 90.0});
    y += size.thickness + apart;
    longest = std::max(longest, size.height + 0.02);
  }
  return longest;
}

}  // namespace

Book book(double thickness, double height, double depth) {
  return {cover_prism(thickness, height, depth),
          block({board + gap, 0.004, -depth + 0.005}, {thickness - board - gap, height - 0.004, -board - gap})};
}

BookRow book_row(double length, double room, double thickness, RandomStream& random) {
  BookRow row;
  double x = 0.01;
  auto colour = static_cast<std::size_t>(random.next_double() * cover_colours);
  while (x < length - 0.35) {
    const double what = random.next_double();
    if (what < 0.02) {
      x += between(random, 0.05, 0.16);
    } else if (what < 0.035) {
      x += add_pile(row, x, room, thickness, random) + 0.02;
    } else {
      const Size size = draw_size(room, thickness, random);
      if (random.next_double() < 0.4) colour = static_cast<std::size_t>(random.next_double() * cover_colours);
      const double lean = what > 0.97 ? between(random, 6.0, 12.0) : 0.0;  // degrees, towards -x
      const double sine = std::sin(lean * pi_double / 180.0);
      x += size.height * sine;
      // The lower left edge of a leaning book stands at x; it leans over the room that was left.
      put(row, book(size.thickness, size.height, size.depth), colour, {x, apart, -between(random, 0.0, 0.025)}, {0.0, 0.0, lean});
      x += size.thickness / std::cos(lean * pi_double / 180.0) + apart;
    }
  }
  return row;
}

Book open_book(double width, double height) {
  constexpr int steps = 6;
  Book result;
  for (const double side : {-1.0, 1.0}) {
    const auto edge = [&](double u) { return side > 0.0 ? u : 1.0 - u; };  // from the fold outwards
    const auto arched = [&](double u, double thickness) {
      const double t = edge(u);
      return thickness * (0.35 + std::sin(pi_double * std::min(1.0, 0.15 + 0.85 * t)) * 0.65 + 0.2 * (1.0 - t)) + 0.007;
    };
    Mesh half;
    for (int i = 0; i <= steps; ++i) {
      const double u = static_cast<double>(i) / steps, x = side * (0.002 + edge(u) * 0.5 * width);
      for (const double z : {0.5 * height, -0.5 * height})
        for (const double y : {0.006, arched(u, 0.018)}) half.vertices.push_back({x, y, z});
    }
    const auto at = [](int station, unsigned corner) { return static_cast<std::uint32_t>(4 * station) + corner; };
    for (int i = 0; i < steps; ++i) {  // corners: 0 low front, 1 high front, 2 low back, 3 high back
      half.faces.push_back({at(i, 1), at(i + 1, 1), at(i + 1, 3), at(i, 3)});
      half.faces.push_back({at(i, 2), at(i + 1, 2), at(i + 1, 0), at(i, 0)});
      half.faces.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
      half.faces.push_back({at(i, 3), at(i + 1, 3), at(i + 1, 2), at(i, 2)});
    }
    half.faces.push_back({at(0, 2), at(0, 0), at(0, 1), at(0, 3)});
    half.faces.push_back({at(steps, 0), at(steps, 2), at(steps, 3), at(steps, 1)});
    result.pages.append(half);
  }
  result.cover = block({-0.5 * width - 0.008, apart, -0.5 * height - 0.005}, {0.5 * width + 0.008, 0.005, 0.5 * height + 0.005});
  return result;
}

}  // namespace gibench::generators
