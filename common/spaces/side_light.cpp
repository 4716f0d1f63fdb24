#include "common/spaces/side_light.h"

#include <algorithm>

#include "common/spaces/side_light_making.h"

namespace gibench {

namespace {

/// Cells that are shared out by area: with the one that each side has, a small multiple of the sides at most.
std::size_t cells_by_area(const World& world) {
  constexpr std::size_t usual = 16384;
  return std::max(usual, world.scene().triangles.size() / 4);
}

}  // namespace

SideLight::SideLight(const World& world, Task& task, const SideLightOptions& options)
    : world_(world), cells_(world, options.sides, cells_by_area(world)) {
  CellLight light = light_of_cells(world, cells_, task);
  cell_irradiance_ = std::move(light.irradiance);
  cell_flags_.assign(cells_.size(), 0);
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
    if (light.seen[cell] != 0) cell_flags_[cell] |= seen_flag;
  judge(light.brightest);
}

void SideLight::judge(std::span<const float> brightest) {
  double squares = 0.0, sum = 0.0, largest = 0.0;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    if (!can_reflect(world_, cells_.triangle(cell), cells_.front(cell))) continue;
    const auto value = static_cast<double>(cell_irradiance_[cell]), area = static_cast<double>(cells_.area(cell));
    squares += value * value * area;
    sum += value * area;
    largest = std::max(largest, value);
  }
  nothing_reached_ = !(largest > 0.0);
  mean_ = nothing_reached_ ? 0.0F : static_cast<float>(squares / sum);
  const float least = sealed_share * mean_;
  const std::size_t sides = 2 * world_.scene().triangles.size();
  irradiance_.assign(sides, 0.0F);
  flags_.assign(sides, 0);
  for (std::uint32_t side = 0; side < sides; ++side) {
    const bool reflects = can_reflect(world_, side / 2, side % 2 == 0);
    double side_sum = 0.0;
    for (std::uint32_t cell = cells_.begin(side); cell < cells_.end(side); ++cell) {
      if (reflects && (nothing_reached_ || brightest[cell] > least)) cell_flags_[cell] |= reached_flag;
      flags_[side] |= cell_flags_[cell];
      side_sum += static_cast<double>(cell_irradiance_[cell]);
    }
    if (const std::uint32_t count = cells_.end(side) - cells_.begin(side); count > 0)
      irradiance_[side] = static_cast<float>(side_sum / count);
  }
}

std::size_t SideLight::bytes() const {
  return cells_.bytes() + (cell_irradiance_.capacity() + irradiance_.capacity()) * sizeof(float) + cell_flags_.capacity() +
         flags_.capacity();
}

}  // namespace gibench
