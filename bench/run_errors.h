/// Errors of a run's answers against a stored reference.
#pragma once

#include <map>
#include <string>

#include "bench/run_method.h"
#include "common/reference/reference_store.h"

namespace gibench {

/// By component, then "surface" and "image". Throws InputError where the reference does not fit the answers.
std::map<std::string, DomainErrors> errors_against(const Reference& reference, const RunOutcome& outcome,
                                                   const Exposure& exposure);

/// The exposure at which the scene is shown: its own, else that of `total`, the picture given.
Exposure exposure_for(const Scene& scene, std::span<const Rgb> total);

}  // namespace gibench
