/// Direct light that glossy elements reflect with their lobes, by direction: the first link of a glossy chain.
#pragma once

#include <span>

#include "common/ray/world.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/fixed_point.h"
#include "methods/antiradiance/glossy.h"
#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {

/// What lights the elements, and what is known of it.
struct DirectSources {
  const Lighting& lighting;
  bool tests_visibility = true;  ///< false: nothing lies between a lit side and a light that it faces
  int samples = 4;               ///< of the lights at each point of a cell
};

/// Radiance of the leaves × bins, W/(m² sr), three floats a bin: the mean over a cell's exposed points of what the lobe makes of
/// light straight from the lights. Nothing at leaves without a lobe.
Vector glossy_direct_radiance(const World& world, const DirectSources& sources, const Elements& elements,
                              const Hierarchy& hierarchy, const GlossyReflection& glossy, const DirectionBins& bins, Task& task);

}  // namespace gibench::antiradiance
