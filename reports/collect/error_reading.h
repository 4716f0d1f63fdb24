/// One measured error as records write it.
#pragma once

#include <optional>

#include "reports/collect/json_reading.h"

namespace gibench::report {

/// {"value", "ci95", "noise_floor", "below_noise_floor"}; empty where there is no value.
std::optional<MeasuredError> error_of(const Json& entry);

}  // namespace gibench::report
