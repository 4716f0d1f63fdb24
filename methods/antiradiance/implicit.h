/// Implicit visibility (Dong, Kautz, Theobalt, Seidel 2007): of the links that an element has in one directional bin the nearest
/// stays.
#pragma once

#include "common/method/task.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// The links of every leaf and of all nodes above it, taken down to the leaf and sorted into bins by direction; each bin keeps
/// its nearest sender, with the bin's form factors together, but no more than the bin's own share of the hemisphere.
LinkTable nearest_links(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins, Task& task);

}  // namespace gibench::antiradiance
