#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/print_json.h"
#include "bench/app/run_report.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"

namespace gibench {

void add_report(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "report", "Makes a web page, tables and plots of a study's results");
  verb->group(verb_group::measuring);
  set_pages(*verb, {"docs/own-scene.md", "docs/reading-errors.md"});
  struct Options {
    std::filesystem::path study, out;
  };
  const auto options = std::make_shared<Options>();
  verb->add_option("study", options->study, "Folder of a study's results")->type_name(value_kind::folder)->required();
  verb->add_option("--out", options->out, "Folder of the report; without it STUDY/report")->type_name(value_kind::folder);
  verb->callback([&call, options] {
    call.action = [&call, options] {
      const std::filesystem::path report = run_report(options->study, options->out, call.common.quiet || call.common.json);
      if (call.common.json) print_json({{"report", (report / "index.html").string()}});
      return ExitStatus::done;
    };
  });
}

}  // namespace gibench
