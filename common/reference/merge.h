/// Merging references of one question: parts, or more samples.
#pragma once

#include "common/reference/reference.h"

namespace gibench {

/// Adds the samples of `more` to `into`, replicate by replicate, weighted by their numbers: the same, to rounding, as if
/// all had been taken at once. The replicates of `more` must come from other random numbers (a continued sequence, or
/// another shard). InputError where the two answer different questions or differ in their replicates.
void merge(Reference& into, const Reference& more);

}  // namespace gibench
