/// Coefficients from point values: the multilevel scheme of Lehtinen et al. 2007, Eq. 6 and 10, and corrections.
#pragma once

#include <cstdint>
#include <span>

#include "common/method/task.h"
#include "methods/meshless/coefficients.h"

namespace gibench::meshless {

/// Sets the coefficients of points of one level: the point values less what the coarser levels give there (Eq. 10).
/// A Shepard approximant does not pass through its data; each correction (0 in the paper) adds to the coefficients what
/// is still missing at the points, which takes them nearer to interpolation without a new value being computed.
void fit_level(Coefficients& coefficients, std::uint32_t level, std::span<const std::uint32_t> points,
               std::span<const Rgb> values, int corrections, Task& task);

/// The coefficients of all points that have a value, level by level from coarse to fine.
Coefficients fit(const Coefficients& values, int corrections, Task& task);

}  // namespace gibench::meshless
