#include "common/geometry/subface_lattice.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace gibench {

namespace {

constexpr double first_guess = 0.25;        // of a cell: how far corners may lie from lattice points at first
constexpr double exact = 2e-3;              // of a cell: and from those of the fitted lattice
constexpr std::size_t most_sparse = 4;      // cells for each triangle
constexpr double least_determinant = 1e-6;  // sine between two sides of a triangle, about

using Place = std::array<int, 2>;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

/// A lattice laid through triangles: two sides of the first give cells, all corners together the exact axes.
class SubfaceLatticeFit {
 public:
  explicit SubfaceLatticeFit(std::span<const Subface> subfaces) : subfaces_(subfaces), places_(subfaces.size()) {}

  bool along(const glm::dvec2& first, const glm::dvec2& second) {
    lattice_ = {};
    known_ = {};
    return guess(first, second) && refine() && lay_out() && add_all();
  }
  SubfaceLattice& lattice() { return lattice_; }

 private:
  using Half = SubfaceLattice::Half;
  using Cell = SubfaceLattice::Cell;
  using Corners = SubfaceLattice::Corners;

  bool guess(const glm::dvec2& first, const glm::dvec2& second) {
    const double determinant = cross(first, second);
    if (!(std::fabs(determinant) > least_determinant * glm::length(first) * glm::length(second))) return false;
    const glm::dvec2 origin(subfaces_.front().corners[0]);
    for (std::size_t s = 0; s < subfaces_.size(); ++s)
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec2 from = glm::dvec2(subfaces_[s].corners[c]) - origin;
        const glm::dvec2 at(cross(from, second) / determinant, cross(first, from) / determinant);
        if (!is_near(at, first_guess, places_[s][c])) return false;
      }
    return true;
  }

  /// The lattice point beside `at`, and whether it lies within `bound`.
  static bool is_near(const glm::dvec2& at, double bound, Place& place) {
    const glm::dvec2 rounded = glm::round(at);
    if (!(glm::length(at - rounded) < bound) || !(std::max(std::fabs(at.x), std::fabs(at.y)) < 1e6)) return false;
    place = {static_cast<int>(rounded.x), static_cast<int>(rounded.y)};
    return true;
  }

  /// Axes by least squares over all corners: lattice coordinates as affine functions of barycentrics.
  bool refine() {
    glm::dmat3 squares(0.0);
    glm::dvec3 columns(0.0), rows(0.0);
    Place low = places_[0][0];
    each_corner([&](const glm::dvec3& at, const Place& place) {
      squares += glm::outerProduct(at, at);
      columns += static_cast<double>(place[0]) * at;
      rows += static_cast<double>(place[1]) * at;
      low = {std::min(low[0], place[0]), std::min(low[1], place[1])};
    });
    const glm::dmat3 inverse = glm::inverse(squares);
    glm::dvec3 column_axis = inverse * columns, row_axis = inverse * rows;
    bool fits = true;
    each_corner([&](const glm::dvec3& at, const Place& place) {
      const double x = glm::dot(column_axis, at) - place[0], y = glm::dot(row_axis, at) - place[1];
      fits = fits && std::fabs(x) < exact && std::fabs(y) < exact;
    });
    column_axis.z -= low[0];
    row_axis.z -= low[1];
    for (auto& corners : places_)
      for (Place& place : corners) place = {place[0] - low[0], place[1] - low[1]};
    lattice_.axis_[0] = Vec2(column_axis);
    lattice_.axis_[1] = Vec2(row_axis);
    lattice_.offset_ = {static_cast<float>(column_axis.z), static_cast<float>(row_axis.z)};
    return fits;
  }

  template <class Take>
  void each_corner(const Take& take) const {
    for (std::size_t s = 0; s < subfaces_.size(); ++s)
      for (std::size_t c = 0; c < 3; ++c)
        take(glm::dvec3(subfaces_[s].corners[c].x, subfaces_[s].corners[c].y, 1.0), places_[s][c]);
  }

  bool lay_out() {
    for (const auto& corners : places_)
      for (const Place& place : corners) {
        lattice_.columns_ = std::max(lattice_.columns_, place[0]);
        lattice_.rows_ = std::max(lattice_.rows_, place[1]);
      }
    const auto cells = static_cast<std::size_t>(lattice_.columns_) * static_cast<std::size_t>(lattice_.rows_);
    if (cells > most_sparse * subfaces_.size()) return false;
    lattice_.cells_.resize(cells);
    return true;
  }

  bool add_all() {
    for (std::size_t s = 0; s < subfaces_.size(); ++s)
      if (!add(s)) return false;
    return true;
  }

  /// Whether the triangle is a free half of a cell and lies in it as those before it do in theirs.
  bool add(std::size_t s) {
    std::array<Place, 3> at = places_[s];
    const int column = std::min({at[0][0], at[1][0], at[2][0]}), row = std::min({at[0][1], at[1][1], at[2][1]});
    std::array<bool, 4> has{};  // corners of the cell: (0, 0), (1, 0), (0, 1), (1, 1)
    for (Place& place : at) {
      place = {place[0] - column, place[1] - row};
      if (place[0] > 1 || place[1] > 1) return false;
      has[static_cast<std::size_t>(place[0] + 2 * place[1])] = true;
    }
    if (std::ranges::count(has, true) != 3) return false;
    const Half half = !has[0]   ? Half::above_falling
                      : !has[3] ? Half::below_falling
                      : !has[1] ? Half::above_rising
                                : Half::below_rising;
    return take(lattice_.cells_[static_cast<std::size_t>(row * lattice_.columns_ + column)], half, subfaces_[s].triangle) &&
           keep(half, corners_of(at));
  }

  static bool take(Cell& cell, Half half, std::uint32_t triangle) {
    const bool falling = half == Half::below_falling || half == Half::above_falling;
    const bool empty =
        cell.triangle(Half::below_rising) == SubfaceLattice::none && cell.triangle(Half::above_rising) == SubfaceLattice::none;
    if (cell.triangle(half) != SubfaceLattice::none || (!empty && cell.falling() != falling)) return false;
    const std::uint32_t kept = cell.halves[half & 1U] & SubfaceLattice::falling_bit;
    cell.halves[half & 1U] = kept | triangle;
    if (falling) cell.halves[0] |= SubfaceLattice::falling_bit;
    return triangle < SubfaceLattice::none;
  }

  static Corners corners_of(const std::array<Place, 3>& at) {
    const auto vector = [&](std::size_t c) { return glm::dvec2(at[c][0] - at[0][0], at[c][1] - at[0][1]); };
    const glm::dvec2 b = vector(1), c = vector(2);
    const double determinant = cross(b, c);
    const glm::dvec2 second = glm::dvec2(c.y, -c.x) / determinant, third = glm::dvec2(-b.y, b.x) / determinant;
    const glm::dvec2 origin(at[0][0], at[0][1]);
    Corners corners{};
    for (std::size_t i = 0; i < 2; ++i) {
      const glm::dvec2& slope = i == 0 ? second : third;
      corners.at_zero[i] = static_cast<float>(-glm::dot(slope, origin));
      corners.along_x[i] = static_cast<float>(slope.x);
      corners.along_y[i] = static_cast<float>(slope.y);
    }
    return corners;
  }

  bool keep(Half half, const Corners& corners) {
    if (known_[half]) return lattice_.corners_[half] == corners;
    known_[half] = true;
    lattice_.corners_[half] = corners;
    return true;
  }

  std::span<const Subface> subfaces_;
  std::vector<std::array<Place, 3>> places_;  // of every subface's corners
  SubfaceLattice lattice_;
  std::array<bool, 4> known_{};  // whether corners_ of that half is set
};

std::optional<SubfaceLattice> SubfaceLattice::of(std::span<const Subface> subfaces) {
  if (subfaces.empty()) return std::nullopt;
  const auto& [a, b, c] = subfaces.front().corners;
  const glm::dvec2 sides[3] = {glm::dvec2(b) - glm::dvec2(a), glm::dvec2(c) - glm::dvec2(b), glm::dvec2(a) - glm::dvec2(c)};
  SubfaceLatticeFit fit(subfaces);
  for (std::size_t i = 0; i < 3; ++i)
    if (fit.along(sides[i], sides[(i + 1) % 3])) return std::move(fit.lattice());
  return std::nullopt;
}

SubfacePoint SubfaceLattice::nearest(Vec2 point, int column, int row) const {
  SubfacePoint best{};
  float best_inside = -1e30F;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
      const Cell& cell = cells_[static_cast<std::size_t>(y * columns_ + x)];
      const Vec2 at = point - Vec2(static_cast<float>(x), static_cast<float>(y));
      for (std::uint32_t above = 0; above < 2; ++above) {
        const auto half = static_cast<Half>((cell.falling() ? below_falling : below_rising) + above);
        if (cell.triangle(half) == none) continue;
        const Vec2 inner = inside(corners_[half], at);
        const float depth = std::min({inner.x, inner.y, 1.0F - inner.x - inner.y});
        if (depth <= best_inside) continue;
        best_inside = depth;
        best = clamped(cell.triangle(half), corners_[half], at);
      }
    }
  return best;
}

}  // namespace gibench
