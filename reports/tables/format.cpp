#include "reports/tables/format.h"

#include <fmt/format.h>

#include <cmath>

namespace gibench::report {

std::string significant(double value, int digits) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return fmt::format("{}", value);
  const double magnitude = std::floor(std::log10(std::abs(value)));
  if (magnitude < -4.0 || magnitude >= 6.0) return fmt::format("{:.{}e}", value, digits - 1);
  const int decimals = std::max(0, digits - 1 - static_cast<int>(magnitude));
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  // 0.9996 at three digits becomes 1.000: one decimal too many.
  const double rounded = std::stod(text);
  if (decimals > 0 && rounded != 0.0 && std::floor(std::log10(std::abs(rounded))) > magnitude)
    return fmt::format("{:.{}f}", value, decimals - 1);
  return text;
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return significant(seconds * 1e6) + " µs";
  if (seconds < 1.0) return significant(seconds * 1e3) + " ms";
  if (seconds < 120.0) return significant(seconds) + " s";
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string large_count(std::uint64_t count) {
  const auto size = static_cast<double>(count);
  if (size < 1e4) return fmt::format("{}", count);
  if (size < 1e6) return significant(size / 1e3) + " k";
  if (size < 1e9) return significant(size / 1e6) + " M";
  return significant(size / 1e9) + " G";
}

std::string factor(double value) { return significant(value, value < 10.0 ? 2 : 3) + "×"; }

std::string exact(double value) { return fmt::format("{}", value); }

std::string error_value(const Metric& metric, double value) {
  return is_percentage(metric) ? significant(value * 100.0) + " %" : significant(value);
}

std::string error_text(const Metric& metric, const MeasuredError& error) {
  if (!error.resolved) return (higher_is_better(metric) ? "≥ " : "≤ ") + error_value(metric, shown_value(metric, error));
  std::string text = error_value(metric, error.value);
  if (!error.low || !error.high) return text;
  const double scale = is_percentage(metric) ? 100.0 : 1.0;
  return text + " [" + significant(*error.low * scale) + ", " + significant(*error.high * scale) + "]";
}

std::string status_text(RunStatus status) { return status == RunStatus::timed_out ? "timed out" : to_string(status); }

}  // namespace gibench::report
