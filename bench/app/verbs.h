/// The verbs of the program. Each has a file of its name that adds its options and says what it does.
#pragma once

#include <functional>

#include "bench/app/exit_status.h"
#include "bench/measure/work_options.h"

namespace CLI {
class App;
}

namespace gibench {

/// What every verb takes.
struct CommonOptions : WorkOptions {
  bool json = false;  ///< the result goes to stdout as one JSON value
};

/// What the command line asked for: filled while it is parsed, then acted on.
struct Call {
  CommonOptions common;
  std::function<ExitStatus()> action;
};

void add_verbs(CLI::App& app, Call& call);

void add_list(CLI::App& app, Call& call);
void add_check(CLI::App& app, Call& call);
void add_run(CLI::App& app, Call& call);
void add_query(CLI::App& app, Call& call);
void add_reference(CLI::App& app, Call& call);
void add_relight(CLI::App& app, Call& call);
void add_compare(CLI::App& app, Call& call);
void add_study(CLI::App& app, Call& call);
void add_report(CLI::App& app, Call& call);

void add_help(CLI::App& app, Call& call);
void add_completion(CLI::App& app, Call& call);

/// The titles under which the help lists verbs.
namespace verb_group {
inline constexpr const char* looking = "Looking around";
inline constexpr const char* computing = "Computing light";
inline constexpr const char* measuring = "Measuring errors";
inline constexpr const char* program = "About the program";
}  // namespace verb_group

/// A verb with the common options.
CLI::App* add_verb(CLI::App& app, Call& call, const char* name, const char* summary);

}  // namespace gibench
