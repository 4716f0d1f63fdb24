#include "common/spaces/side_cells.h"

#include <cmath>

#include "common/scene/scene.h"

namespace gibench {

namespace {

constexpr float most_rows = 1024.0F;

}  // namespace

SideCells::SideCells(const World& world, CellSides sides, std::size_t cells_by_area) : world_(world) {
  const Scene& scene = world.scene();
  const auto triangles = static_cast<std::uint32_t>(scene.triangles.size());
  const auto sides_of = [&](std::uint32_t t) {
    return sides == CellSides::all || scene.objects[scene.triangle_object[t]].two_sided ? 2U : 1U;
  };
  double area = 0.0;
  for (std::uint32_t t = 0; t < triangles; ++t) area += sides_of(t) * static_cast<double>(world.area(t));
  const double cell_area = area / static_cast<double>(std::max<std::size_t>(1, cells_by_area));
  rows_.assign(triangles, 0);
  begin_.assign(2 * std::size_t{triangles} + 1, 0);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const auto own = static_cast<double>(world.area(t));
    if (own > 0.0)
      rows_[t] =
          static_cast<std::uint16_t>(std::clamp(std::round(static_cast<float>(std::sqrt(own / cell_area))), 1.0F, most_rows));
    const std::uint32_t cells = std::uint32_t{rows_[t]} * rows_[t];
    for (std::uint32_t side = 0; side < 2; ++side)
      begin_[2 * t + side + 1] = begin_[2 * t + side] + (side < sides_of(t) ? cells : 0);
  }
  side_.resize(begin_.back());
  for (std::uint32_t side = 0; side < 2 * triangles; ++side)
    std::fill(side_.begin() + begin_[side], side_.begin() + begin_[side + 1], side);
}

float SideCells::area(std::uint32_t cell) const {
  const std::uint32_t t = triangle(cell);
  return world_.area(t) / static_cast<float>(std::uint32_t{rows_[t]} * rows_[t]);
}

SideCells::Position SideCells::position(std::uint32_t cell) const {
  const std::uint32_t rows = rows_[triangle(cell)];
  const std::uint32_t local = cell - begin_[side_[cell]];
  // The largest row with row (2n − row) ≤ local: of the root n − sqrt(n² − local), put right where rounding missed.
  const auto n = static_cast<double>(rows);
  auto row = static_cast<std::uint32_t>(n - std::sqrt(std::max(0.0, n * n - static_cast<double>(local))));
  while (row > 0 && row * (2 * rows - row) > local) --row;
  while ((row + 1) * (2 * rows - row - 1) <= local) ++row;
  const std::uint32_t along = local - row * (2 * rows - row);
  return {row, along / 2, along % 2 != 0};
}

Vec2 SideCells::barycentrics(std::uint32_t cell, Vec2 place) const {
  const Position at = position(cell);
  const Vec2 corner(static_cast<float>(at.row), static_cast<float>(at.column));
  return (corner + (at.turned ? Vec2(1.0F) - place : place)) / static_cast<float>(rows_[triangle(cell)]);
}

Vec2 SideCells::place_in(std::uint32_t cell, Vec2 barycentrics) const {
  const Position at = position(cell);
  const Vec2 corner(static_cast<float>(at.row), static_cast<float>(at.column));
  const Vec2 inside = barycentrics * static_cast<float>(rows_[triangle(cell)]) - corner;
  return at.turned ? Vec2(1.0F) - inside : inside;
}

std::size_t SideCells::bytes() const {
  return rows_.capacity() * sizeof(std::uint16_t) + (begin_.capacity() + side_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace gibench
