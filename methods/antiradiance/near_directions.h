/// Near elements see each other under many directions at once: their links are split, one direction each.
#pragma once

#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// Replaces every link between near leaves by up to sixteen, from four points of the sender's cell to four of the receiver's, in
/// proportion to their form factors; where the form factor is above a tenth, by up to 64 directions of the receiver that meet
/// the sender's cell. Together they have the link's own. `ways`: of every link of the table made, the unit
/// direction in which its light travels.
void split_near_links(const Elements& elements, const Hierarchy& hierarchy, LinkTable& links, std::vector<Vec3>& ways,
                      Task& task);

}  // namespace gibench::antiradiance
