/// The manual page gibench(1), made from the tree of verbs and options.
#pragma once

#include <string>

#include "bench/app/call_tree.h"

namespace gibench {

/// As troff with the man macros, in ASCII.
std::string manual_page(const CallTree& tree, const std::string& version);

}  // namespace gibench
