/// The command-line options that say where methods are asked, the same for every verb that asks them.
#pragma once

#include "bench/measure/measuring.h"

namespace CLI {
class App;
}

namespace gibench {

/// --surface-samples, --pixel-samples, --camera, --width, --no-pictures, --bounces
void add_measuring_options(CLI::App& verb, MeasuringOptions& options);
/// --bounces alone
void add_bounces_option(CLI::App& verb, std::optional<int>& bounces);

/// The options as they would be written after `gibench reference SCENE`, those at their defaults left out.
std::string command_line_of(const MeasuringOptions& options);

}  // namespace gibench
