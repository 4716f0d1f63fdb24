/// The area that each of the coarsest samples stands for, by which means over the surfaces are taken.
#pragma once

#include <vector>

#include "methods/meshless/groups.h"
#include "methods/meshless/hierarchy.h"

namespace gibench::meshless {

/// ∫ B_k dA over all lit sides as a share of the area that level 0 covers, one for each of its points: the mean of what level 0
/// gives is Σ share · coefficient. Poisson discs lie denser where surfaces bend, and every group has one at least, so that an
/// even mean over the samples would count small things too much.
std::vector<double> coarsest_shares(const World& world, const Groups& groups, const Hierarchy& hierarchy, Task& task);

}  // namespace gibench::meshless
