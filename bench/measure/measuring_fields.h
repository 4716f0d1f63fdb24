/// The options that say where methods are asked, each written once: for the command line, studies and child processes.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "bench/measure/measuring.h"

namespace gibench {

/// A switch is true unless its option is given; an optional number is absent unless it is given.
using MeasuringMember =
    std::variant<std::size_t MeasuringOptions::*, int MeasuringOptions::*, std::optional<int> MeasuringOptions::*,
                 std::string MeasuringOptions::*, bool MeasuringOptions::*>;

struct MeasuringField {
  const char* option;  ///< on the command line
  const char* key;     ///< in a study file; empty: not there, nor among the options of every verb
  const char* meaning;
  MeasuringMember member;
  std::size_t least = 0, most = 0;  ///< of a number
  bool shows_default = false;       ///< in the help
};
std::span<const MeasuringField> measuring_fields();

/// What differs from the defaults, as it is written after `gibench run|reference SCENE`, option and value apart.
std::vector<std::string> arguments_of(const MeasuringOptions& options);

}  // namespace gibench
