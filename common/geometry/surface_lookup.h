/// The surface at a given point: what a query asks about.
#pragma once

#include <optional>

#include "common/ray/world.h"

namespace gibench {

/// The surface within `max_distance` metres of `point` whose side agrees best with the unit `normal`: fronts before
/// backs, then the smaller angle (60 degrees at most), then the smaller distance. Empty where there is none. The sample
/// lies on the surface, at its point nearest to `point`. Looks at every triangle.
std::optional<SurfaceSample> find_surface_point(const World& world, const Vec3& point, const Vec3& normal, float max_distance);

}  // namespace gibench
