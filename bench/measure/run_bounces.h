/// Errors of each bounce order: a method is asked for the light of each number of reflections separately.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/measure/run_method.h"
#include "common/reference/reference_store.h"

namespace gibench {

/// The stored reference of some light paths; empty where there is none.
using FindReference = std::function<std::optional<Reference>(const std::string& light_paths)>;

/// For 0 … `last` reflections between a light and the surface asked about. The method runs once more for each number, as its
/// answer for n is what n reflections add to n − 1. A bounce whose references are lacking is left out, their light paths
/// added to `lacking`.
std::vector<BounceErrors> errors_per_bounce(const LoadedScene& scene, const MethodChoice& choice,
                                            const MeasuringOptions& measuring, const PlanOptions& options,
                                            const WorkOptions& common, int last, const Exposure& exposure,
                                            const FindReference& find, std::vector<std::string>& lacking);

}  // namespace gibench
