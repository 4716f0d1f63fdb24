#include "common/geometry/subface_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/core/prefetch.h"

namespace gibench {

namespace {

constexpr float rim = 1e-5F;             // of a barycentric: cells are given what reaches this near to them
constexpr double cells_a_subface = 1.5;  // along either barycentric, so that most cells meet a few triangles

std::uint32_t cell_of(float coordinate, std::uint32_t width) {
  const float scaled = coordinate * static_cast<float>(width);
  return scaled > 0.0F ? std::min(width - 1, static_cast<std::uint32_t>(scaled)) : 0U;
}

struct Box {
  Vec2 low, high;
  bool meets_triangle() const { return high.x >= 0.0F && high.y >= 0.0F && low.x + low.y <= 1.0F; }
};

Box box_of(const Subface& subface) {
  const auto& [a, b, c] = subface.corners;
  return {glm::min(a, glm::min(b, c)) - Vec2(rim), glm::max(a, glm::max(b, c)) + Vec2(rim)};
}

}  // namespace

std::uint32_t SubfaceLookup::add_entry(const Subface& subface) {
  const glm::dvec2 a(subface.corners[0]), b = glm::dvec2(subface.corners[1]) - a, c = glm::dvec2(subface.corners[2]) - a;
  const double determinant = b.x * c.y - c.x * b.y;
  const double inverse = determinant != 0.0 ? 1.0 / determinant : 0.0;
  entries_.push_back({subface.corners[0],
                      {static_cast<float>(c.y * inverse), static_cast<float>(-c.x * inverse), static_cast<float>(-b.y * inverse),
                       static_cast<float>(b.x * inverse)},
                      subface.triangle});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

bool SubfaceLookup::reaches(const Entry& entry, std::uint32_t x, std::uint32_t y, std::uint32_t width) {
  const float size = 1.0F / static_cast<float>(width);
  const Vec2 low = Vec2(static_cast<float>(x), static_cast<float>(y)) * size - entry.corner;
  // A barycentric is linear: its largest value over the cell is at the corner that its slopes point to.
  const auto largest = [&](float along_x, float along_y) {
    return along_x * low.x + along_y * low.y + size * (std::max(0.0F, along_x) + std::max(0.0F, along_y));
  };
  const auto& m = entry.matrix;
  const float margin = -1e-3F;
  return largest(m[0], m[1]) >= margin && largest(m[2], m[3]) >= margin && 1.0F + largest(-m[0] - m[2], -m[1] - m[3]) >= margin;
}

void SubfaceLookup::add(std::span<const Subface> subfaces) {
  if (subfaces.size() <= 1) {
    rasters_.push_back({static_cast<std::uint32_t>(subfaces.size()), subfaces.empty() ? 0 : subfaces.front().triangle});
    return;
  }
  if (auto cells = SubfaceLattice::of(subfaces)) {
    rasters_.push_back({lattice, static_cast<std::uint32_t>(lattices_.size())});
    lattices_.push_back(std::move(*cells));
    return;
  }
  const auto width = static_cast<std::uint32_t>(std::ceil(cells_a_subface * std::sqrt(static_cast<double>(subfaces.size()))));
  rasters_.push_back({width, static_cast<std::uint32_t>(cell_begin_.size())});
  std::vector<std::vector<std::uint32_t>> cells(std::size_t{width} * width);
  for (const Subface& subface : subfaces) {
    const Box box = box_of(subface);
    if (!box.meets_triangle()) continue;
    const std::uint32_t entry = add_entry(subface);
    for (std::uint32_t y = cell_of(box.low.y, width); y <= cell_of(box.high.y, width); ++y)
      for (std::uint32_t x = cell_of(box.low.x, width); x <= cell_of(box.high.x, width); ++x)
        if (reaches(entries_[entry], x, y, width)) cells[std::size_t{y} * width + x].push_back(entry);
  }
  for (const auto& cell : cells) {
    cell_begin_.push_back(static_cast<std::uint32_t>(cell_entries_.size()));
    cell_entries_.insert(cell_entries_.end(), cell.begin(), cell.end());
  }
  cell_begin_.push_back(static_cast<std::uint32_t>(cell_entries_.size()));
}

std::uint32_t SubfaceLookup::cell_at(const Raster& raster, Vec2 barycentrics) {
  return raster.first_cell + cell_of(barycentrics.y, raster.width) * raster.width + cell_of(barycentrics.x, raster.width);
}

/// A search reads a cell, its first entry's number and that entry: each for all points before the next.
void SubfaceLookup::prefetch(std::span<const OuterPoint> points) const {
  std::array<std::uint32_t, 64> cells;
  for (std::size_t begin = 0; begin < points.size(); begin += cells.size()) {
    std::size_t count = 0;
    for (const OuterPoint& point : points.subspan(begin, std::min(cells.size(), points.size() - begin))) {
      const Raster& raster = rasters_[point.outer];
      if (raster.width == lattice || raster.width == 1) continue;
      cells[count] = cell_at(raster, point.barycentrics);
      gibench::prefetch(&cell_begin_[cells[count++]]);
    }
    for (std::size_t i = 0; i < count; ++i) gibench::prefetch(cell_entries_.data() + cell_begin_[cells[i]]);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t first = cell_begin_[cells[i]];
      if (first < cell_begin_[cells[i] + 1]) gibench::prefetch(&entries_[cell_entries_[first]]);
    }
  }
}

SubfacePoint SubfaceLookup::search(const Raster& raster, Vec2 barycentrics) const {
  const std::uint32_t cell = cell_at(raster, barycentrics);
  SubfacePoint best{};
  float best_inside = -1e30F;
  for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
    const Entry& entry = entries_[cell_entries_[i]];
    const Vec2 at = barycentrics - entry.corner;
    const float second = entry.matrix[0] * at.x + entry.matrix[1] * at.y, third = entry.matrix[2] * at.x + entry.matrix[3] * at.y;
    const float inside = std::min(std::min(second, third), 1.0F - second - third);
    if (inside > best_inside) {
      best_inside = inside;
      best = {entry.triangle, second, third};
      if (inside >= 0.0F) break;
    }
  }
  // Clamped onto the triangle: the point was outside by rounding at most.
  best.second = std::clamp(best.second, 0.0F, 1.0F);
  best.third = std::clamp(best.third, 0.0F, 1.0F - best.second);
  return best;
}

std::size_t SubfaceLookup::bytes() const {
  std::size_t lattices = 0;
  for (const SubfaceLattice& cells : lattices_) lattices += cells.bytes();
  return lattices + rasters_.size() * sizeof(Raster) + (cell_begin_.size() + cell_entries_.size()) * sizeof(std::uint32_t) +
         entries_.size() * sizeof(Entry);
}

}  // namespace gibench
