/// A stored reference as pictures and facts that other programs can read.
#pragma once

#include <filesystem>

#include "bench/record/reference_record.h"
#include "common/reference/reference_store.h"

namespace gibench {

/// reference.json and, with a camera, reference.exr: R,G,B total; direct.*, indirect.*; half_a.*, half_b.*: the total
/// by the even and by the odd replicates.
void write_reference_files(const std::filesystem::path& folder, const Scene& scene, const Reference& reference);

}  // namespace gibench
