/// The distance of a question's point from what finite elements resolve badly: edges, and other surfaces.
#pragma once

#include "truth_case.h"

namespace gibench::truth {

/// Metres from the question's point to the nearest surface that does not hold it, or to the nearest edge of its own plane's
/// surface.
double clearance_of(const Scene& scene, const Question& question);

/// A point with less clearance than this share of the scene's diagonal is near an edge.
constexpr double near_edge = 0.02;
bool is_near_edge(const TruthCase& truth, const Question& question);

}  // namespace gibench::truth
