/// Implicit visibility (Dong, Kautz, Theobalt, Seidel 2007): of the links that an element has in one directional bin the nearest
/// stays.
#pragma once

#include "common/method/task.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"
#include "methods/antiradiance/settings.h"

namespace gibench::antiradiance {

/// The links of every leaf and of all nodes above it, taken down to the leaf and sorted into bins: the one that the link's
/// direction lies in, and those across whose middle the sender lies. The winner (see BinWinner) gets the bin: its whole share of
/// the hemisphere where something lies across its middle, what the links in it hold together otherwise.
LinkTable nearest_links(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins, BinWinner winner,
                        Task& task);

}  // namespace gibench::antiradiance
