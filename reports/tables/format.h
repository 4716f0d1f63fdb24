/// Numbers and texts as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "reports/collect/study.h"
#include "reports/tables/metric_info.h"

namespace gibench::report {

/// What stands where nothing was measured.
inline constexpr std::string_view dash = "–";

/// `digits` significant digits, as 0.0231, 1230 or 2.31e-07.
std::string significant(double value, int digits = 3);
/// 12.3 ms, 4.56 s, 2 min 5 s, 1 h 2 min.
std::string duration(double seconds);
/// 7.80 M, 512.
std::string large_count(std::uint64_t count);
/// 12.3×.
std::string factor(double value);
/// Every digit needed to read the same double again.
std::string exact(double value);

/// The value with its unit: "2.31 %" or "0.0231".
std::string error_value(const Metric& metric, double value);
/// "2.31 % [2.20, 2.43]", with "≤ " and the noise floor for an error below it.
std::string error_text(const Metric& metric, const MeasuredError& error);

/// done, refused, timed out, …
std::string status_text(RunStatus status);

}  // namespace gibench::report
