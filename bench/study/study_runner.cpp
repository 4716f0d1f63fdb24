#include "bench/study/study_runner.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <atomic>
#include <ctime>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "bench/measure/cancellation.h"
#include "bench/measure/measuring_fields.h"
#include "bench/record/process_record.h"
#include "bench/record/relight_record.h"
#include "bench/record/run_record.h"
#include "bench/study/child_outcome.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/reference/folder_replacement.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

/// Calls work(0), …, work(count − 1) on `jobs` threads; the first exception is thrown here once all threads ended.
void for_each_job(int jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr first_error;
  std::mutex error_mutex;
  const auto take_jobs = [&] {
    for (std::size_t i = next++; i < count && !cancellation()->load(); i = next++) try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(error_mutex);
        if (!first_error) first_error = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(take_jobs);
  take_jobs();
  for (std::thread& thread : threads) thread.join();
  if (first_error) std::rethrow_exception(first_error);
}

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
  if (error)
    throw InputError(folder.string(), "cannot be made (" + error.message() + ")", "choose a folder that you may write to");
}

}  // namespace

StudyRunner::StudyRunner(const Study& study, StudySettings settings, const WorkOptions& common)
    : study_(study),
      settings_(std::move(settings)),
      common_(common),
      folders_{settings_.out},
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
    if (is_due(i) && is_kept(runs_[i].id, key_of(runs_[i]))) ++kept;
  for (std::size_t i = 0; i < relights_.size(); ++i)
    if (is_due(runs_.size() + i) && is_kept(relights_[i].id, key_of(relights_[i]))) ++kept;
  return fmt::format("finished runs kept in {}: {} of {}; the same command{} does the rest", folder, kept, due_,
                     settings_.force ? " without --force" : "");
}

void StudyRunner::run_stages() {
  make_folder(folders_.root / "runs");
  make_folder(folders_.scratch());
  check_scenes();
  write_manifest();
  make_references();
  write_manifest();
  run_all();
  write_manifest();
  std::error_code ignored;
  fs::remove(folders_.scratch(), ignored);  // stays while another shard works in it
  stop_if_cancelled();
}

ChildResult StudyRunner::child(std::vector<std::string> arguments, const ChildLimits& limits, const std::string& name) const {
  for (const std::string& argument : {std::string("--threads"), std::to_string(common_.threads), std::string("--quiet")})
    arguments.push_back(argument);
  ChildResult result = run_child(arguments, limits, folders_.scratch(), name);
  std::error_code ignored;
  for (const char* extension : {".out", ".err", ".error"}) fs::remove(folders_.scratch() / (name + extension), ignored);
  return result;
}

void StudyRunner::check_scenes() {
  for (std::size_t s = 0; s < scenes_.size(); ++s) {
    const StudyScene& scene = study_.scenes[s];
    const ChildResult result = child({"check", scene.file.string(), "--json"}, {}, "check-" + scene.name);
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

void StudyRunner::make_references() {
  if (!study_.reference) return;
  std::vector<bool> needed(scenes_.size(), false);
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (is_own(i)) needed[runs_[i].scene] = true;
  for_each_job(settings_.jobs, scenes_.size(), [&](std::size_t scene) {
    if (!needed[scene] || scenes_[scene].skipped) return;
    make_reference(scene);
    make_path_references(scene);
  });
  stop_if_cancelled();
}

void StudyRunner::make_reference(std::size_t scene) {
  SceneState& state = scenes_[scene];
  const std::string& name = study_.scenes[scene].name;
  const fs::path folder = folders_.reference(name);
  std::vector<std::string> arguments = reference_arguments(scene, study_.measuring);
  arguments.insert(arguments.end(), {"--out", folder.string(), "--force"});
  const ChildLimits limits = reference_limits();
  const ChildResult result = child(arguments, limits, "reference-" + name);
  if (result.end == ChildEnd::cancelled) return;
  if (const std::string reason = reason_of(result, limits); !reason.empty()) {
    state.reference_message = "no reference: " + reason;
    state.reference.reset();
    tell(fmt::format("{}: {}", name, state.reference_message));
    return;
  }
  state.reference = reference_if_there(name);
  tell(fmt::format("{}: reference ready, {:.1f} s", name, result.seconds));
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

void StudyRunner::run_for(const std::string& id, const std::string& key,
                          const std::function<std::vector<std::string>(const fs::path& made)>& arguments) {
  if (!settings_.force && is_kept(id, key)) {
    ++finished_;
    return;
  }
  fs::path made = folders_.run(id);
  made += ".new";
  std::error_code ignored;
  fs::remove_all(made, ignored);
  const ChildResult result = child(arguments(made), {study_.time_limit_seconds, study_.memory_limit_bytes}, id);
  if (result.end == ChildEnd::cancelled || cancellation()->load()) {
    fs::remove_all(made, ignored);
    return;
  }
  keep(id, result, key, made);
}

void StudyRunner::run_one(const PlannedRun& run) {
  const StudyVariant& variant = study_.variants[run.variant];
  run_for(run.id, key_of(run), [&](const fs::path& made) {
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
                                       (folders_.root / "references" / "store").string()};
    for (const std::string& setting : variant.settings) arguments.insert(arguments.end(), {"--set", setting});
    const std::vector<std::string> measuring = arguments_of(study_.measuring);
    arguments.insert(arguments.end(), measuring.begin(), measuring.end());
    const std::vector<std::string> plan = plan_arguments(variant.plan);
    arguments.insert(arguments.end(), plan.begin(), plan.end());
    if (!study_.reference) arguments.insert(arguments.end(), {"--reference", "none"});
    return arguments;
  });
}

void StudyRunner::relight_one(const PlannedRelight& planned) {
  const StudyRelight& relight = study_.relights[planned.relight];
  run_for(planned.id, key_of(planned), [&](const fs::path& made) {
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

void StudyRunner::keep(const std::string& id, const ChildResult& child_result, const std::string& key, const fs::path& made) {
  const ChildLimits limits{study_.time_limit_seconds, study_.memory_limit_bytes};
  const std::string reason = reason_of(child_result, limits);
  ProcessRecord entry;
  entry.key = key, entry.status = status_of(child_result), entry.message = reason;
  entry.wall_seconds = child_result.seconds;
  if (child_result.end == ChildEnd::exited) entry.exit_code = child_result.exit_code;
  if (child_result.error) entry.error = child_result.error->code;
  if (child_result.peak_bytes > 0) entry.peak_bytes = entry.process_peak_bytes = child_result.peak_bytes;
  // A run that succeeded records its peak before it loads the library that writes its pictures.
  if (const std::uint64_t peak = recorded_peak_bytes(made); peak > 0) entry.peak_bytes = peak;
  make_folder(made);  // there already after a run that came to its end
  write_file_atomically(made / process_file, to_json(entry).dump(2) + "\n");
  fs::path partial = made;
  partial += ".partial";
  std::error_code ignored;
  fs::remove_all(partial, ignored);  // left by a child that was killed
  replace_folder(made, folders_.run(id));
  const std::size_t finished = ++finished_;
  tell(fmt::format("[{}/{}] {} {}, {:.1f} s{}{}", finished, due_, id, to_string(entry.status), child_result.seconds,
                   reason.empty() ? "" : ": ", reason));
  {
    const std::lock_guard lock(terminal_);
    progress_->update("", static_cast<double>(finished) / static_cast<double>(due_));
  }
  write_manifest();
}

bool StudyRunner::is_kept(const std::string& id, const std::string& key) const {
  const std::optional<ProcessRecord> recorded = read_process_record(folders_.run(id) / process_file);
  return recorded && recorded->key == key &&
         (recorded->status == RunStatus::done || recorded->status == RunStatus::refused ||
          recorded->status == RunStatus::timed_out);
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

void StudyRunner::tell(const std::string& line) {
  const std::lock_guard lock(terminal_);
  progress_->note(line);
}

}  // namespace gibench
