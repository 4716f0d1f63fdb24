/// Errors of a run's answers against a stored reference.
#pragma once

#include <map>
#include <string>

#include "bench/measure/run_method.h"
#include "common/reference/reference_store.h"

namespace gibench {

/// Over the seeds with which the answers were given. Throws InputError where the reference does not fit the answers.
ComponentErrors errors_against(const Reference& reference, const Answers& surface, const std::optional<Answers>& image,
                               const Exposure& exposure, std::span<const SeedAnswers> other_seeds = {});

/// What compares the run's errors with those of other runs against the same reference, whose facts stand in its record.
PairRecord pairs_against(const Reference& reference, const RunOutcome& outcome);

/// The reference of some paths compared with that of all: their model error. Both with equally many replicates or the
/// surplus is left out; replicate by replicate the two may share random numbers, so that their noise is that of the
/// difference. InputError where they answer different questions otherwise.
ComponentErrors model_errors(const Reference& all, const Reference& some, const Exposure& exposure);

/// The exposure at which the scene is shown: its own, else that of `total`, the picture given.
Exposure exposure_for(const Scene& scene, std::span<const Rgb> total);

}  // namespace gibench
