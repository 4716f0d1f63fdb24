/// The program as a function, for a `main` of its own and for programs that bring further methods.
#pragma once

#include <vector>

#include "common/method/method_entry.h"

namespace gibench {

/// Parses the call, runs one verb, turns what went wrong into one line and an exit status. `own_methods` are listed after the
/// built-in ones and used like them. Once in a process: it listens for signals.
int run_program(int argc, char** argv, const std::vector<MethodEntry>& own_methods = {});

}  // namespace gibench
