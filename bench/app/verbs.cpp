#include "bench/app/verbs.h"

#include <CLI/CLI.hpp>

#include "bench/app/progress_bar.h"

namespace gibench {

void add_verbs(CLI::App& app, Call& call) {
  call.common.show_progress = show_on_terminal;
  add_list(app, call);
  add_check(app, call);
  add_run(app, call);
  add_query(app, call);
  add_reference(app, call);
  add_relight(app, call);
  add_compare(app, call);
  add_study(app, call);
  add_report(app, call);
  add_help(app, call);
  add_completion(app, call);
}

CLI::App* add_verb(CLI::App& app, Call& call, const char* name, const char* summary) {
  CLI::App* verb = app.add_subcommand(name, summary);
  verb->add_option("--seed", call.common.seed, "Seed of every random number")->capture_default_str();
  verb->add_option("--threads", call.common.threads, "Threads; 0: all cores")->check(CLI::Range(0, 4096))->capture_default_str();
  verb->add_flag("--quiet", call.common.quiet, "No progress and no notes, only the result and errors");
  verb->add_flag("--json", call.common.json, "The result to stdout as one JSON value");
  return verb;
}

}  // namespace gibench
