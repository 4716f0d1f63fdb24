#include "bench/study/study_runner.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <functional>
#include <nlohmann/json.hpp>
#include <system_error>

#include "bench/measure/cancellation.h"
#include "bench/measure/measuring_fields.h"
#include "bench/measure/result_files.h"
#include "bench/record/checksums.h"
#include "bench/record/process_record.h"
#include "bench/record/relight_record.h"
#include "bench/record/run_record.h"
#include "bench/study/child_outcome.h"
#include "bench/study/for_each_job.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/write_failure.h"
#include "common/reference/folder_replacement.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

/// Of the work, as the run's record says; 0 where there is no record.
std::uint64_t recorded_peak_bytes(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / result_file, ignored)) return 0;
  try {
    return read_run_record(folder / result_file).peak_bytes;
  } catch (const InputError&) {
    return 0;
  }
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_write_failure(folder, "cannot be made", error.value(), "choose a folder that you may write to");
}

/// run.json, where it is there and cannot be used.
std::vector<DamagedFile> damaged_record(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / process_file, ignored) || read_process_record(folder / process_file)) return {};
  return {{process_file, "is not as it was written"}};
}

/// One that is a result: a failure or a crash is tried again.
bool is_result(RunStatus status) {
  return status == RunStatus::done || status == RunStatus::refused || status == RunStatus::timed_out;
}

}  // namespace

StudyRunner::StudyRunner(const Study& study, StudySettings settings, const WorkOptions& common)
    : study_(study),
      settings_(std::move(settings)),
      common_(common),
      folders_{settings_.out, settings_.shard},
      runs_(plan_runs(study)),
      relights_(plan_relights(study)),
      scenes_(study.scenes.size()),
      progress_(common.progress_of("study " + study.name)),
      created_(fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))) {}
StudyRunner::~StudyRunner() = default;

void StudyRunner::run() {
  try {
    run_stages();
  } catch (const WorkError&) {
    if (!cancellation()->load()) throw;
    throw WorkError("cancelled; " + describe_kept());
  }
}

std::string StudyRunner::describe_kept() const {
  const std::string folder = folders_.root.string();
  if (due_ == 0)  // not all keys of runs are known before the references stand
    return fmt::format(
        "runs in {} that were finished before are kept, and references as far as they were made; the same command "
        "does the rest",
        folder);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (is_due(i) && is_kept(runs_[i])) ++kept;
  for (std::size_t i = 0; i < relights_.size(); ++i)
    if (is_due(runs_.size() + i) && is_kept(relights_[i])) ++kept;
  return fmt::format("finished runs kept in {}: {} of {}; the same command{} does the rest", folder, kept, due_,
                     settings_.force ? " without --force" : "");
}

void StudyRunner::run_stages() {
  const fs::path scratch = folders_.scratch();
  std::error_code ignored;
  fs::remove_all(scratch, ignored);  // left by a study that was killed
  make_folder(folders_.root / "runs");
  make_folder(scratch);
  check_scenes();
  write_manifest();
  make_references();
  write_manifest();
  run_all();
  write_manifest();
  fs::remove_all(scratch, ignored);
  stop_if_cancelled();
}

ChildResult StudyRunner::child(std::vector<std::string> arguments, const ChildLimits& limits) const {
  for (const std::string& argument : {std::string("--threads"), std::to_string(common_.threads), std::string("--quiet")})
    arguments.push_back(argument);
  const std::vector<std::string> limiting = arguments_of(settings_.model_limits);
  arguments.insert(arguments.end(), limiting.begin(), limiting.end());
  const fs::path scratch = folders_.scratch();
  const std::string name = std::to_string(children_++);
  ChildResult result = run_child(arguments, limits, scratch, name);
  std::error_code ignored;
  for (const char* extension : {".out", ".err", ".error"}) fs::remove(scratch / (name + extension), ignored);
  return result;
}

void StudyRunner::check_scenes() {
  for (std::size_t s = 0; s < scenes_.size(); ++s) {
    const StudyScene& scene = study_.scenes[s];
    const ChildResult result = child({"check", scene.file.string(), "--json"}, {});
    stop_if_cancelled();
    if (succeeded(result)) {
      scenes_[s].check = check_record_of(nlohmann::ordered_json::parse(result.out));
      if (study_.reference) scenes_[s].reference = reference_if_there(scene.name);
    } else if (ended_with(result, ErrorCode::missing_file)) {  // of models that are not on this machine
      scenes_[s].skipped = reason_of(result, {});
      tell(fmt::format("skipped {}: {}", scene.name, *scenes_[s].skipped));
    } else if (ended_with(result, ErrorCode::bad_input)) {
      throw InputError("scene " + scene.name, reason_of(result, {}));
    } else {
      throw WorkError(fmt::format("scene {} cannot be checked: {}", scene.name, reason_of(result, {})));
    }
  }
}

bool StudyRunner::is_own(std::size_t place) const {
  return place % static_cast<std::size_t>(settings_.shard.of) == static_cast<std::size_t>(settings_.shard.index);
}

bool StudyRunner::is_due(std::size_t place) const {
  const std::size_t scene =
      place < runs_.size() ? runs_[place].scene : study_.relights[relights_[place - runs_.size()].relight].scene;
  return is_own(place) && !scenes_[scene].skipped;
}

void StudyRunner::run_all() {
  std::vector<std::function<void()>> own;
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (is_due(i)) own.emplace_back([this, i] { run_one(runs_[i]); });
  for (std::size_t i = 0; i < relights_.size(); ++i)
    if (is_due(runs_.size() + i)) own.emplace_back([this, i] { relight_one(relights_[i]); });
  due_ = own.size();
  for_each_job(settings_.jobs, own.size(), [&](std::size_t i) { own[i](); });
  progress_->hide();
}

template <class Planned>
void StudyRunner::run_for(const Planned& planned, ProcessRecord asked,
                          const std::function<std::vector<std::string>(const fs::path& made)>& arguments) {
  const fs::path folder = folders_.run(planned.id);
  if (!settings_.force) {
    const auto recorded = finished(planned);
    const std::vector<DamagedFile> damaged = recorded ? damaged_files(folder, recorded->files) : damaged_record(folder);
    if (recorded && damaged.empty()) {
      ++finished_;
      return;
    }
    if (!damaged.empty())
      tell(fmt::format("{} {}; it is run again", (folder / damaged.front().name).string(), damaged.front().problem));
  }
  const fs::path made = folders_.made_beside(folder);
  remove_made(made);
  const ChildResult result = child(arguments(made), {study_.time_limit_seconds, study_.memory_limit_bytes});
  if (result.end == ChildEnd::cancelled || cancellation()->load()) remove_made(made);
  else keep(planned.id, result, std::move(asked), made);
}

void StudyRunner::run_one(const PlannedRun& run) {
  const StudyVariant& variant = study_.variants[run.variant];
  ProcessRecord asked;
  asked.key = key_of(run), asked.reference = scenes_[run.scene].state, asked.path_reference = path_state(run);
  run_for(run, asked, [&](const fs::path& made) {
    std::vector<std::string> arguments{"run",
                                       study_.scenes[run.scene].file.string(),
                                       "--method",
                                       variant.method,
                                       "--out",
                                       made.string(),
                                       "--force",
                                       "--seed",
                                       std::to_string(common_.seed),
                                       "--reference-seed",
                                       std::to_string(study_.measuring.reference_seed),
                                       "--references",
                                       folders_.store().string()};
    for (const std::string& setting : variant.settings) arguments.insert(arguments.end(), {"--set", setting});
    const std::vector<std::string> measuring = arguments_of(study_.measuring);
    arguments.insert(arguments.end(), measuring.begin(), measuring.end());
    if (study_.method_seeds > 1) arguments.insert(arguments.end(), {"--method-seeds", std::to_string(study_.method_seeds)});
    const std::vector<std::string> plan = plan_arguments(variant.plan);
    arguments.insert(arguments.end(), plan.begin(), plan.end());
    if (!asked.reference) arguments.insert(arguments.end(), {"--reference", "none"});
    for (const auto& state : {asked.reference, asked.path_reference})
      if (state) arguments.insert(arguments.end(), {"--reference-state", *state});
    return arguments;
  });
}

void StudyRunner::relight_one(const PlannedRelight& planned) {
  const StudyRelight& relight = study_.relights[planned.relight];
  ProcessRecord asked;
  asked.key = key_of(planned);
  run_for(planned, asked, [&](const fs::path& made) {
    make_folder(made);
    std::vector<std::string> arguments{"relight",  study_.scenes[relight.scene].file.string(),
                                       "--method", relight.method,
                                       "--lights", relight.lights.string(),
                                       "--out",    (made / relight_file).string(),
                                       "--seed",   std::to_string(common_.seed)};
    for (const std::string& setting : relight.settings) arguments.insert(arguments.end(), {"--set", setting});
    const std::vector<std::string> options = arguments_of(relight.options);
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  });
}

void StudyRunner::keep(const std::string& id, const ChildResult& child_result, ProcessRecord entry, const fs::path& made) {
  const ChildLimits limits{study_.time_limit_seconds, study_.memory_limit_bytes};
  const std::string reason = reason_of(child_result, limits);
  entry.status = status_of(child_result), entry.message = reason;
  entry.wall_seconds = child_result.seconds;
  if (child_result.end == ChildEnd::exited) entry.exit_code = child_result.exit_code;
  if (child_result.error) entry.error = child_result.error->code;
  if (child_result.peak_bytes > 0) entry.peak_bytes = entry.process_peak_bytes = child_result.peak_bytes;
  // A run that succeeded records its peak before it loads the library that writes its pictures.
  if (const std::uint64_t peak = recorded_peak_bytes(made); peak > 0) entry.peak_bytes = peak;
  if (entry.status != RunStatus::done) remove_made(made), entry.reference.reset(), entry.path_reference.reset();
  make_folder(made);  // there already after a run that came to its end
  entry.files = checksums_of(made, {process_file, log_file});
  write_file_atomically(made / process_file, to_json(entry).dump(2) + "\n");
  replace_folder(made, folders_.run(id));
  const std::size_t finished = ++finished_;
  tell(fmt::format("[{}/{}] {} {}, {:.1f} s{}{}", finished, due_, id, to_string(entry.status), child_result.seconds,
                   reason.empty() ? "" : ": ", reason));
  if (!is_result(entry.status)) tell_not_done(fmt::format("{} {}: {}", id, to_string(entry.status), reason));
  {
    const std::lock_guard lock(terminal_);
    progress_->update("", static_cast<double>(finished) / static_cast<double>(due_));
  }
  write_manifest();
}

bool StudyRunner::is_current(const ProcessRecord& recorded, const PlannedRun& run) const {
  if (recorded.key != key_of(run)) return false;
  const SceneState& scene = scenes_[run.scene];
  if (!scene.references_known || recorded.status != RunStatus::done) return true;
  // Where a reference cannot be made now, what was held against it before stays.
  const auto path = path_state(run);
  return (recorded.reference == scene.state || (!scene.state && recorded.reference == scene.earlier)) &&
         (recorded.path_reference == path || (!path && scene.paths.contains(run.variant)));
}

bool StudyRunner::is_current(const ProcessRecord& recorded, const PlannedRelight& relight) const {
  return recorded.key == key_of(relight);
}

template <class Planned>
std::optional<ProcessRecord> StudyRunner::finished(const Planned& planned) const {
  auto recorded = read_process_record(folders_.run(planned.id) / process_file);
  const bool stays = recorded && is_current(*recorded, planned) && is_result(recorded->status) &&
                     (recorded->status != RunStatus::done || !recorded->files.empty());
  return stays ? recorded : std::nullopt;
}

template <class Planned>
bool StudyRunner::is_kept(const Planned& planned) const {
  const auto recorded = finished(planned);
  return recorded && damaged_files(folders_.run(planned.id), recorded->files).empty();
}

/// Empty where there is none or it is damaged.
std::optional<ReferenceRecord> StudyRunner::reference_if_there(const std::string& scene) const {
  const fs::path file = folders_.reference(scene) / reference_file;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  try {
    return read_reference_record(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void StudyRunner::tell_not_done(const std::string& line) {
  const std::lock_guard lock(terminal_);
  not_done_.push_back(line);
}

void StudyRunner::tell(const std::string& line) {
  const std::lock_guard lock(terminal_);
  progress_->note(line);
}

}  // namespace gibench
