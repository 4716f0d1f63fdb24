/// An estimate of the light that reaches each side of each triangle, and of what the scene's cameras see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "common/ray/world.h"
#include "common/spaces/side_cells.h"

namespace gibench {

/// What is asked about.
struct SideLightOptions {
  CellSides sides = CellSides::lit;  ///< all: also what arrives at the black backs of one-sided objects
};

/// Tells lit space from space that is sealed away from all light: the inside of walls, closed cupboards, what lies under the
/// ground. Straight light from the scene's lights at some points of each cell of each side, then E = D + Σ ρ(hit) E(hit) / n over
/// n cosine-distributed rays of each cell, a few rounds of it, with what the materials reflect at normal incidence as ρ. A coarse
/// estimate of irradiance, in W/m², mean of the channels: cracks let some light into sealed space, so that its magnitude decides.
/// A few million rays, or four for each side where there are more sides than that. Immutable after construction.
class SideLight {
 public:
  /// What gets less than this share of mean() counts as sealed.
  static constexpr float sealed_share = 1e-3F;

  /// Keeps a reference to the world, which must outlive it. The lights are those of its scene.
  SideLight(const World& world, Task& task, const SideLightOptions& options = {});

  /// W/m², the mean over the side; 0 of black sides, unless these are asked about, and of triangles without area.
  float irradiance(std::uint32_t triangle, bool front) const { return irradiance_[SideCells::side_number(triangle, front)]; }
  /// W/m², of the part of the side around a point; 0 of triangles without area, and of black sides as above.
  float irradiance(std::uint32_t triangle, bool front, Vec2 barycentrics) const {
    const std::uint32_t cell = cells_.at(triangle, front, barycentrics);
    return cell != SideCells::none ? cell_irradiance_[cell] : 0.0F;
  }
  /// W/m², of the irradiance weighted with itself, ΣE²A/ΣEA: dark surfaces do not dilute it. 0 where no light reaches anything.
  float mean() const { return mean_; }
  /// Whether more than the share of mean() reaches some part of the side. Where no light reaches any side that can reflect, all
  /// of these count as reached (nothing_reached()). False of black sides and of triangles without area.
  bool is_reached(std::uint32_t triangle, bool front) const { return flag(triangle, front, reached_flag); }
  /// The same of the part of the side around a point.
  bool is_reached(std::uint32_t triangle, bool front, Vec2 barycentrics) const {
    return cell_flag(triangle, front, barycentrics, reached_flag);
  }
  bool is_reached(const SurfaceSample& sample) const {
    return is_reached(sample.triangle, is_front(sample), sample.barycentrics);
  }
  /// Whether a camera of the scene sees some part of the side, or one diffuse reflection leads from there to what it sees. False
  /// without a camera.
  bool is_seen(std::uint32_t triangle, bool front) const { return flag(triangle, front, seen_flag); }
  bool is_seen(std::uint32_t triangle, bool front, Vec2 barycentrics) const {
    return cell_flag(triangle, front, barycentrics, seen_flag);
  }
  bool is_seen(const SurfaceSample& sample) const { return is_seen(sample.triangle, is_front(sample), sample.barycentrics); }

  /// No light reaches any side that can reflect it.
  bool nothing_reached() const { return nothing_reached_; }
  const SideCells& cells() const { return cells_; }
  float cell_irradiance(std::uint32_t cell) const { return cell_irradiance_[cell]; }  ///< W/m²
  bool is_cell_reached(std::uint32_t cell) const { return (cell_flags_[cell] & reached_flag) != 0; }
  bool is_cell_seen(std::uint32_t cell) const { return (cell_flags_[cell] & seen_flag) != 0; }
  std::size_t bytes() const;

 private:
  static constexpr std::uint8_t reached_flag = 1, seen_flag = 2;

  bool is_front(const SurfaceSample& sample) const { return glm::dot(world_.normal(sample.triangle), sample.normal) >= 0.0F; }
  bool flag(std::uint32_t triangle, bool front, std::uint8_t which) const {
    return (flags_[SideCells::side_number(triangle, front)] & which) != 0;
  }
  bool cell_flag(std::uint32_t triangle, bool front, Vec2 barycentrics, std::uint8_t which) const {
    const std::uint32_t cell = cells_.at(triangle, front, barycentrics);
    return cell != SideCells::none && (cell_flags_[cell] & which) != 0;
  }
  /// `brightest`: of every cell, what decides whether it is reached.
  void judge(std::span<const float> brightest);

  const World& world_;
  SideCells cells_;
  std::vector<float> cell_irradiance_, irradiance_;  ///< of every cell, of every side; W/m²
  std::vector<std::uint8_t> cell_flags_, flags_;
  float mean_ = 0.0F;
  bool nothing_reached_ = false;
};

}  // namespace gibench
