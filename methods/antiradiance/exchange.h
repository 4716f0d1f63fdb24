/// The exchange between nodes, more accurate than in the oracle: links keep the factors that are made here.
#pragma once

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// A_i F_ij of the cells of two elements, m²: the mean of both directions' point-to-polygon form factors over points of the
/// cells, so symmetric up to rounding, and bounded by the smaller area. `back_i`: light arrives on i's back; `back_j`: it
/// leaves j's.
float cell_exchange(const Elements& elements, std::uint32_t i, bool back_i, std::uint32_t j, bool back_j);

/// A_p F_pq of two nodes as refine_factors() makes it, m²; nothing where the sides that the sender names do not face each other.
float node_exchange(const Elements& elements, const Hierarchy& hierarchy, bool cells, std::uint32_t p, const Sender& sender);

/// Makes the links' factors anew. Elements that nearly touch (three radii) and are not nearly in one plane are taken as their
/// cells (`cells`); other elements up to eight radii as discs cut into quarters. Inner nodes are long or square, not round: near
/// ones are taken as the discs of their children, or of their children's.
void refine_factors(const Elements& elements, const Hierarchy& hierarchy, bool cells, LinkTable& links, Task& task);

}  // namespace gibench::antiradiance
