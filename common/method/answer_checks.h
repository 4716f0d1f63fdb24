/// Checks of every answer, whichever method gives it: sizes before the work, every value written after it.
#pragma once

#include "common/method/shading.h"
#include "common/method/stage_report.h"

namespace gibench {

/// A programmer's error where a span is neither empty nor as long as the samples, or directions are missing.
void check_sizes(const ShadeRequest& request, const ShadeAnswer& answer);
/// Nothing that a caller left there passes for an answer.
void fill_with_nan(const ShadeAnswer& answer);
/// Turns the report of a stage that succeeded into invalid_output at the first value that was not written or is not finite.
void check_written(const ShadeAnswer& answer, StageReport& report);

}  // namespace gibench
