#include <nlohmann/json.hpp>

#include "bench/record/machine.h"
#include "bench/record/process_record.h"
#include "bench/record/run_record.h"
#include "bench/study/study_runner.h"
#include "common/core/atomic_file.h"

namespace gibench {

using Json = nlohmann::ordered_json;

std::string StudyRunner::key_of(const PlannedRun& run) const {
  const SceneState& scene = scenes_[run.scene];
  // The samples of the reference count: a better one gives other errors.
  const std::string reference_state =
      scene.reference ? scene.reference->facts.key + std::to_string(scene.reference->facts.total_samples()) : "none";
  return run_key(study_, run, common_, scene.check.at("key").get<std::string>(), reference_state);
}

std::string StudyRunner::key_of(const PlannedRelight& planned) const {
  const StudyRelight& relight = study_.relights[planned.relight];
  return relight_key(relight, common_, scenes_[relight.scene].check.at("key").get<std::string>(), read_file(relight.lights));
}

Json StudyRunner::scene_entry(std::size_t scene) const {
  const SceneState& state = scenes_[scene];
  const std::string& name = study_.scenes[scene].name;
  Json entry{{"name", name}, {"file", study_.scenes[scene].file.filename().string()}};
  if (state.skipped) {
    entry["skipped"] = *state.skipped;
    return entry;
  }
  if (!state.check.is_object()) return entry;
  for (const Json& camera : state.check.at("cameras"))
    if (study_.measuring.camera.empty() || camera.at("name") == study_.measuring.camera) {
      entry["camera"] = camera.at("name");
      break;
    }
  entry["key"] = state.check.at("key");
  if (state.check.contains("exposure")) entry["exposure"] = state.check.at("exposure");
  else if (state.reference && state.reference->exposure) entry["exposure"] = to_json(*state.reference->exposure);
  if (state.reference && state.reference->camera)
    entry["resolution"] = {state.reference->camera->width, state.reference->camera->height};
  entry["geometry"] = state.check.at("geometry");
  entry["effects_called_for"] = Json::array();
  for (const Json& effect : state.check.at("effects"))
    if (effect.at("called_for").get<bool>()) entry["effects_called_for"].push_back(effect.at("effect"));
  entry["effects"] = state.check.at("effects");
  entry["bounce_bound"] = state.check.at("bounce_bound");
  entry["analysis_seconds"] = state.check.at("analysis_seconds");
  if (state.reference) entry["reference"] = "references/" + name;
  else if (!state.reference_message.empty()) entry["message"] = state.reference_message;
  return entry;
}

Json StudyRunner::run_entry(const PlannedRun& run) const {
  const StudyVariant& variant = study_.variants[run.variant];
  Json entry{{"id", run.id},
             {"label", variant.label},
             {"scene", study_.scenes[run.scene].name},
             {"method", variant.method},
             {"parameters", to_json(variant.parameters)}};
  add_outcome(entry, run.id, scenes_[run.scene].skipped ? std::string() : key_of(run), run.scene);
  return entry;
}

Json StudyRunner::relight_entry(const PlannedRelight& planned) const {
  const StudyRelight& relight = study_.relights[planned.relight];
  Json entry{{"id", planned.id},
             {"label", relight.label},
             {"scene", study_.scenes[relight.scene].name},
             {"method", relight.method},
             {"parameters", to_json(relight.parameters)},
             {"lights", relight.lights.filename().string()}};
  add_outcome(entry, planned.id, scenes_[relight.scene].skipped ? std::string() : key_of(planned), relight.scene);
  return entry;
}

/// How the run ended, and where its records lie.
void StudyRunner::add_outcome(Json& entry, const std::string& id, const std::string& key, std::size_t scene) const {
  if (scenes_[scene].skipped) {
    entry["status"] = "skipped";
    entry["message"] = *scenes_[scene].skipped;
  } else if (const auto recorded = read_process_record(folders_.run(id) / process_file); recorded && recorded->key == key) {
    add_to_entry(*recorded, entry);
  } else {
    entry["status"] = "skipped";
    entry["message"] = "not run yet";
  }
  entry["folder"] = "runs/" + id;
}

Json StudyRunner::manifest() const {
  Json scenes = Json::array(), runs = Json::array(), relights = Json::array();
  for (std::size_t s = 0; s < scenes_.size(); ++s) scenes.push_back(scene_entry(s));
  for (const PlannedRun& run : runs_) runs.push_back(run_entry(run));
  for (const PlannedRelight& relight : relights_) relights.push_back(relight_entry(relight));
  return {{"gibench_study", 1},
          {"name", study_.name},
          {"version", version()},
          {"commit", commit()},
          {"machine", to_json(this_machine())},
          {"created", created_},
          {"seed", common_.seed},
          {"threads", common_.threads},
          {"jobs", settings_.jobs},
          {"study", Json(*study_.json)},
          {"scenes", scenes},
          {"runs", runs},
          {"relights", relights}};
}

void StudyRunner::write_manifest() const {
  const std::lock_guard lock(manifest_);
  write_file_atomically(folders_.manifest(), manifest().dump(2) + "\n");
}

}  // namespace gibench
