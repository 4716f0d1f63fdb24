/// Every method, in the order in which they are listed. A new method is an include and a line in registry.cpp (README.md, "A new
/// method").
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "common/method/method_entry.h"

namespace gibench {

std::span<const MethodEntry> all_methods();

/// Throws InputError, the known names listed, for a name that is not registered. `place` is where it is named.
const MethodEntry& find_method(std::string_view name, const std::string& place = "--method");

}  // namespace gibench
