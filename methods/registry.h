/// Every method, in the order in which they are listed. A new method of this tree is an include and a line in registry.cpp
/// (README.md, "A new method"); a program built elsewhere adds its own.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "common/method/method_entry.h"

namespace gibench {

std::span<const MethodEntry> all_methods();

/// Adds a method after those that are there, before any of them is used: spans and references to entries do not stay valid.
/// Throws InputError for a name that is taken.
void add_method(MethodEntry entry);

/// Throws InputError, the known names listed, for a name that is not registered. `place` is where it is named.
const MethodEntry& find_method(std::string_view name, const std::string& place = "--method");

}  // namespace gibench
