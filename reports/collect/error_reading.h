/// One measured error as records write it.
#pragma once

#include <optional>

#include "common/core/error.h"
#include "common/core/enum_names.h"
#include "reports/collect/json_reading.h"

namespace gibench::report {

/// {"value", "ci95", "noise_floor", "below_noise_floor"}; empty where there is no value.
std::optional<MeasuredError> error_of(const Json& entry);

/// Throws InputError, the known ones listed, for a name that is none of `all`.
template <class All>
auto known_name(const All& all, const std::string& name) {
  const auto found = find_named(all, name);
  if (!found) throw InputError("errors", "unknown name '" + name + "'", "known: " + list_names(all));
  return *found;
}

}  // namespace gibench::report
