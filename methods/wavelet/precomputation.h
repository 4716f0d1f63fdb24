/// The offline part of the method: everything that geometry alone decides.
#pragma once

#include <string>

#include "common/method/stage_report.h"
#include "methods/wavelet/elements.h"
#include "methods/wavelet/reconstruction.h"
#include "methods/wavelet/settings.h"
#include "methods/wavelet/transport_operator.h"

namespace gibench::wavelet {

struct Precomputed {
  Elements elements;
  TransportOperator transport;
  Reconstruction reconstruction;
  std::size_t bytes() const { return elements.bytes() + transport.bytes() + reconstruction.bytes(); }
};

/// `tests_visibility`: something may lie between two surfaces. Where the blocks do not fit into the memory budget the thresholds
/// are doubled until they do, and the report says so. Fills termination, message and counters.
Precomputed precompute(const World& world, const Settings& settings, bool tests_visibility, Task& task, StageReport& report);

/// The two sides that most of a scene's triangles may have in all: every pair of elements is looked at.
inline constexpr std::size_t most_sides = 8192;

}  // namespace gibench::wavelet
