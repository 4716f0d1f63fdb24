/// Table cells of the usual kinds; what is absent gives the dash, and nothing in CSV.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/core/byte_size.h"
#include "reports/tables/format.h"
#include "reports/tables/table.h"

namespace gibench::report {

template <class T, class Format, class Raw>
Cell cell(const std::optional<T>& value, Format format, Raw raw) {
  return value ? Cell{format(*value), raw(*value)} : Cell{std::string(dash), ""};
}

inline Cell text_cell(const std::string& text) { return {text.empty() ? std::string(dash) : text, text}; }
inline Cell seconds_cell(std::optional<double> seconds) { return cell(seconds, duration, exact); }
inline Cell bytes_cell(std::optional<std::uint64_t> bytes) {
  const auto text = [](std::uint64_t value) { return byte_size(static_cast<double>(value)); };
  return cell(bytes, text, [](std::uint64_t value) { return std::to_string(value); });
}
inline Cell count_cell(std::optional<std::uint64_t> count) {
  return cell(count, large_count, [](std::uint64_t value) { return std::to_string(value); });
}
inline Cell number_cell(std::optional<double> number) {
  return cell(
      number, [](double value) { return significant(value); }, exact);
}

inline Cell flag_cell(bool flag) { return text_cell(flag ? "yes" : "no"); }
/// A flag of what may be absent.
template <class T>
Cell yes_or_no(const std::optional<T>& value, bool T::*flag) {
  return value ? flag_cell((*value).*flag) : text_cell("");
}

template <class Integer>
Cell whole_cell(const std::optional<Integer>& number) {
  return text_cell(number ? std::to_string(*number) : "");
}
/// The error with its interval.
inline Cell error_cell(const Metric& metric, const MeasuredError* error) {
  return error ? Cell{error_text(metric, *error), exact(error->value)} : text_cell("");
}
inline Cell floor_cell(const Metric& metric, const MeasuredError* error) {
  return cell(
      error ? error->noise_floor : std::nullopt, [&](double floor) { return error_value(metric, floor); }, exact);
}

/// The value of a key, empty where it is absent.
template <class Key, class T>
std::optional<T> at(const std::map<Key, T>& values, const Key& key) {
  const auto found = values.find(key);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace gibench::report
