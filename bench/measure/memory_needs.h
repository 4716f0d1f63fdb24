/// The memory that a question's points and values take, held against what there is before any work begins.
#pragma once

#include <cstdint>

#include "common/reference/reference.h"

namespace gibench {

/// Bytes of the points, of a method's answers there with each of so many seeds, and of a reference of eight replicates.
struct MemoryNeeds {
  double surface = 0.0, image = 0.0;
};
MemoryNeeds memory_needs(const ReferenceQuestion& question, int seeds = 1);

/// Throws InputError that names --surface-samples, or --width and --pixel-samples (the larger of both needs), where both together
/// do not fit into `available` bytes.
void require_memory(const ReferenceQuestion& question, std::uint64_t available, int seeds = 1);

}  // namespace gibench
