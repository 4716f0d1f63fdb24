/// The series of bounces solved on the coarse levels, and one gather over all of them.
#pragma once

#include "methods/meshless/bounces.h"

namespace gibench::meshless {

/// The bounces are solved on the coarse levels (settings.bounce_levels), from one gather at each of their points, whose hits
/// serve all of them. Then one gather over all levels sees direct light and that solution, which makes it one bounce more.
IndirectLight coarse_bounces(LightAtPoints& light, const Transport& transport, const Coefficients* direct,
                             const Settings& settings, const SeriesBound& bound, Task& task);

}  // namespace gibench::meshless
