/// The placement of basis points: a hierarchical Poisson-disc distribution of every group, and the backface test
/// (Lehtinen et al. 2007, section 6.1).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/geometry/poisson_disc.h"
#include "common/method/task.h"
#include "methods/meshless/groups.h"
#include "methods/meshless/settings.h"

namespace gibench::meshless {

/// Whether points lie inside geometry: the ray along the normal meets the back of a one-sided surface, and so
/// do all other rays of the test. 1 for a point that is clear of it. Counts its rays in the task.
void clear_of_backfaces(const World& world, std::span<const DiscPoint> points, std::span<std::uint8_t> clear, int rays,
                        Task& task);

struct Placement {
  std::vector<std::vector<std::vector<DiscPoint>>> points;  ///< by level, by group
  double radius = 0.0;                                      ///< of level 0, metres
  std::uint64_t proposals = 0;
  std::uint64_t inside = 0;  ///< proposals that were taken for points inside geometry
  std::string refusal;       ///< why nothing was placed: the settings ask for more points than there may be
};

/// Points of all levels, at most, as foreseen.
inline constexpr double most_points = 32e6;

/// Places every level of every group; incomplete where the task was cancelled.
Placement place_points(const World& world, const Groups& groups, const Settings& settings, Task& task);

}  // namespace gibench::meshless
