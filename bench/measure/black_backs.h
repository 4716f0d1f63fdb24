/// A warning where a camera sees mostly the black backs of one-sided objects, as inside a model that is inside out.
#pragma once

#include <string>

#include "bench/measure/camera_points.h"

namespace gibench {

/// One sentence that tells the share and the object that shows most of them; empty where they are less than half of what the
/// camera's rays meet.
std::string warning_of_black_backs(const World& world, const CameraPoints& points);

}  // namespace gibench
