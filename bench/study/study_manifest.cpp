/// The record of a study while it runs, collected from its folder.
#include <nlohmann/json.hpp>

#include "bench/record/checksums.h"
#include "bench/record/file_lock.h"
#include "bench/study/study_runner.h"
#include "common/core/atomic_file.h"

namespace gibench {

using Json = nlohmann::ordered_json;

std::string StudyRunner::key_of(const PlannedRun& run) const {
  return run_key(study_, run, common_, scenes_[run.scene].check.value().analysis.key);
}

std::string StudyRunner::key_of(const PlannedRelight& planned) const {
  const StudyRelight& relight = study_.relights[planned.relight];
  return relight_key(study_, relight, common_, scenes_[relight.scene].check.value().analysis.key, read_file(relight.lights));
}

StudySceneRecord StudyRunner::record_of_scene(std::size_t scene) const {
  const SceneState& state = scenes_[scene];
  StudySceneRecord record;
  record.name = study_.scenes[scene].name;
  record.file = study_.scenes[scene].file.filename().string();
  record.skipped = state.skipped;
  if (state.skipped || !state.check) return record;
  record.analysis = state.check->analysis;
  for (const MeasuredCamera& camera : state.check->cameras)
    if (!record.camera && (study_.measuring.camera.empty() || camera.name == study_.measuring.camera))
      record.camera = camera.name;
  record.exposure = state.check->exposure;
  record.message = state.reference_message;
  if (!state.reference) return record;
  if (!record.exposure) record.exposure = state.reference->exposure;
  if (const auto& camera = state.reference->camera) record.resolution = {camera->width, camera->height};
  record.reference = "references/" + record.name;
  return record;
}

template <class Planned>
ProcessRecord StudyRunner::outcome_of(const Planned& planned, std::size_t scene) const {
  ProcessRecord not_run;
  not_run.status = RunStatus::skipped;
  not_run.message = scenes_[scene].skipped.value_or("not run yet");
  if (scenes_[scene].skipped) return not_run;
  const auto recorded = read_process_record(folders_.run(planned.id) / process_file);
  return recorded && is_current(*recorded, planned) ? *recorded : not_run;
}

StudyRunRecord StudyRunner::record_of(const PlannedRun& run) const {
  const StudyVariant& variant = study_.variants[run.variant];
  return {run.id,
          variant.label,
          study_.scenes[run.scene].name,
          variant.method,
          variant.parameters,
          {},
          outcome_of(run, run.scene),
          "runs/" + run.id};
}

StudyRunRecord StudyRunner::record_of(const PlannedRelight& planned) const {
  const StudyRelight& relight = study_.relights[planned.relight];
  return {planned.id,
          relight.label,
          study_.scenes[relight.scene].name,
          relight.method,
          relight.parameters,
          relight.lights.filename().string(),
          outcome_of(planned, relight.scene),
          "runs/" + planned.id};
}

StudyRecord StudyRunner::record() const {
  StudyRecord record;
  record.name = study_.name, record.origin = Origin::here(), record.created = created_;
  record.seed = common_.seed, record.threads = common_.threads, record.jobs = settings_.jobs;
  record.study = study_.json;
  for (std::size_t s = 0; s < scenes_.size(); ++s) record.scenes.push_back(record_of_scene(s));
  for (const PlannedRun& run : runs_) record.runs.push_back(record_of(run));
  for (const PlannedRelight& relight : relights_) record.relights.push_back(record_of(relight));
  return record;
}

void StudyRunner::write_manifest() const {
  const std::lock_guard lock(manifest_);
  // Of shards at work at the same time the last one to write has seen what all the others finished.
  const FileLock among_shards(folders_.root / "manifest.lock", folders_.root, FileLock::WhenTaken::wait);
  Json json = to_json(record());
  seal(json);
  write_file_atomically(folders_.manifest(), json.dump(2) + "\n");
}

}  // namespace gibench
