/// Text of files on a terminal: without control characters, which could move its cursor, change its colours or its title.
#pragma once

#include <string>
#include <string_view>

namespace gibench {

/// UTF-8 of printable characters on one line: line ends and tabs become blanks; other control characters, marks that turn the
/// direction of writing, and bytes that are no UTF-8 are written as a backslash, x and two hexadecimal digits for each byte.
std::string printable_text(std::string_view text);

}  // namespace gibench
