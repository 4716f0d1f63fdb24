/// Results as JSON on stdout.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace gibench {

/// One value, indented, with a newline.
void print_json(const nlohmann::ordered_json& json);

}  // namespace gibench
