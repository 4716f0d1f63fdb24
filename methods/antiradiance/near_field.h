/// Form factors of elements that nearly touch, where discs are no longer like the cells they stand for.
#pragma once

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// A_i F_ij of the cells, m²: the mean of both directions' point-to-polygon form factors over points of the cells, so
/// symmetric up to rounding, and bounded by the smaller area. `back_i`: light arrives on i's back; `back_j`: it leaves j's.
float cell_exchange(const Elements& elements, std::uint32_t i, bool back_i, std::uint32_t j, bool back_j);

/// Puts better factors where discs are close: cells within three radii of each other that are not nearly in one plane, discs
/// cut into quarters up to eight. `cells` false: discs everywhere.
void correct_near_field(const Elements& elements, const Hierarchy& hierarchy, bool cells, LinkTable& links, Task& task);

}  // namespace gibench::antiradiance
