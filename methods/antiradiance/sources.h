/// Direct light on the elements: what they are the first to reflect.
#pragma once

#include <vector>

#include "common/core/rgb.h"
#include "common/lighting/direct_light.h"
#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {

/// Irradiance straight from the lights, W/m², of every leaf: the mean over its exposed points, `samples` light samples each.
std::vector<Rgb> direct_irradiance(const World& world, const DirectLight& light, const Elements& elements,
                                   const Hierarchy& hierarchy, int samples, Task& task);

}  // namespace gibench::antiradiance
