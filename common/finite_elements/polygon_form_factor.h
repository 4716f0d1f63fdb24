/// The form factor from a point to a polygon, in closed form.
#pragma once

#include <span>

#include "common/core/vec.h"

namespace gibench {

/// Form factor from a surface element at `point` to the polygon, in [0, 1]: Lambert's formula over its edges, clipped to the
/// hemisphere of the unit `normal`. The polygon is planar or nearly so, has at most 6 corners (more are a failed check), and
/// counts from both sides.
float polygon_form_factor(const Vec3& point, const Vec3& normal, std::span<const Vec3> corners);

}  // namespace gibench
