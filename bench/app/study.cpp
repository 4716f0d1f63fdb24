#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "bench/app/call_tree.h"
#include "bench/app/options.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/scene_search.h"
#include "bench/record/file_lock.h"
#include "bench/study/study_runner.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct StudyOptions {
  std::string study;
  StudySettings settings;
  std::string shard = "0/1";
  bool dry_run = false;
};

void list_runs(const Study& study, bool json) {
  Json list = Json::array();
  for (const PlannedRun& run : plan_runs(study)) {
    const StudyVariant& variant = study.variants[run.variant];
    if (!json) fmt::print("{}\n", run.id);
    else
      list.push_back(
          {{"id", run.id}, {"scene", study.scenes[run.scene].name}, {"method", variant.method}, {"label", variant.label}});
  }
  if (json) print_json(list);
}

/// Nothing but the locks of studies: one that has only just begun.
bool holds_only_locks(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  return std::all_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    return name.starts_with("study-") && name.ends_with(".lock");
  });
}

/// Accepts a folder that is new, empty or a study's.
void check_folder(const fs::path& out) {
  std::error_code ignored;
  if (!fs::exists(out, ignored)) return;
  if (!fs::is_directory(out, ignored)) throw InputError(out.string(), "is not a folder", "choose another --out");
  if (!fs::exists(out / "runs", ignored) && !holds_only_locks(out))
    throw InputError(out.string(), "is not empty and holds no study", "choose another --out");
}

/// Throws WorkError where something was to be done and is not.
void check_done(const StudyRunner& runner, const std::string& name) {
  const std::vector<std::string>& lacking = runner.not_done();
  if (lacking.empty()) return;
  const std::string more = lacking.size() == 1 ? "" : fmt::format(" (and {} more, see {})", lacking.size() - 1, manifest_file);
  throw WorkError(fmt::format("{}: not done: {}{}; the same command tries again", name, lacking.front(), more));
}

void print_summary(const StudyRecord& record, const fs::path& out) {
  std::map<std::string, int> counts;
  for (const StudyRunRecord& run : record.runs) ++counts[to_string(run.process.status)];
  std::string text;
  for (const auto& [status, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, status);
  fmt::print("{}: {}; results in {}\n", record.name, text, out.string());
}

ExitStatus study(StudyOptions options, const CommonOptions& common) {
  options.settings.shard = parse_shard(options.shard);
  const Study study = read_study(find_study(options.study));
  if (options.dry_run) {
    list_runs(study, common.json);
    return ExitStatus::done;
  }
  if (options.settings.out.empty()) throw InputError("--out", "is missing", "name the folder for the results");
  const fs::path out = options.settings.out = followed(options.settings.out);
  check_folder(out);
  const FileLock lock(out / fmt::format("study-{}.lock", options.settings.shard.index), out, FileLock::WhenTaken::refuse);
  StudyRunner runner(study, options.settings, common);
  runner.run();
  const StudyRecord record = runner.record();
  if (common.json) print_json(to_json(record));
  else if (!common.quiet) print_summary(record, out);
  check_done(runner, study.name);
  return ExitStatus::done;
}

}  // namespace

void add_study(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "study", "Runs scenes x methods x parameter sweeps into a folder; resumes by itself");
  verb->group(verb_group::measuring);
  set_pages(*verb, {"docs/own-scene.md", "docs/files.md", "scenes/README.md"});
  const auto options = std::make_shared<StudyOptions>();
  verb->add_option("study", options->study, "Study file, or the name of one that comes with the program")
      ->type_name(value_kind::study)
      ->required();
  verb->add_option("--out", options->settings.out, "Folder for the results")->type_name(value_kind::folder);
  verb->add_flag("--dry-run", options->dry_run, "Only list the runs");
  verb->add_flag("--force", options->settings.force, "Redo what is finished");
  verb->add_option("--jobs", options->settings.jobs, "Runs at a time; more than 1 disturbs the timings")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  add_model_limits(*verb, options->settings.model_limits);
  verb->add_option("--shard", options->shard, "i/n: only the runs whose place in the plan mod n is i")->capture_default_str();
  verb->callback([&call, options] { call.action = [&call, options] { return study(*options, call.common); }; });
}

}  // namespace gibench
