/// The surface samples on which every method is compared: uniform by area over all lit sides, independent of
/// any view.
#pragma once

#include <cstdint>
#include <vector>

#include "common/ray/world.h"

namespace gibench {

/// `count` samples, stratified by area over all sides that light can leave (both sides of two-sided objects);
/// degenerate triangles get none, and coincident ones only where they are in front. The same seed gives the same samples. Empty
/// where the scene has no area.
std::vector<SurfaceSample> area_uniform_samples(const World& world, std::size_t count, std::uint64_t seed);

}  // namespace gibench
