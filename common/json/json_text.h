/// JSON text to values, with errors that name line and column.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gibench {

/// Throws InputError for a syntax error (line and column), a number too large for double precision, or a key
/// that appears twice in one object (JSON would silently take the last). `file` names the text in messages.
nlohmann::json parse_json(const std::string& text, const std::string& file);

}  // namespace gibench
