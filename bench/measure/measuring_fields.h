/// The options that say where methods are asked, as a table.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/measure/measuring.h"
#include "bench/measure/option_fields.h"

namespace gibench {

/// Those without a key are not among the options of every verb.
std::span<const OptionField<MeasuringOptions>> measuring_fields();

/// What differs from the defaults, as it is written after `gibench run|reference SCENE`, option and value apart.
std::vector<std::string> arguments_of(const MeasuringOptions& options);

}  // namespace gibench
