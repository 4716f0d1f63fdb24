#include "bench/record/study_record.h"

#include "bench/record/json_fields.h"

namespace gibench {

namespace {

/// Adds what the scene's check found, but for the key, which stands further up.
void write_analysis(Json& json, const SceneAnalysis& analysis) {
  json["geometry"] = to_json(analysis.geometry);
  json["effects_called_for"] = Json::array();
  for (const EffectEvidence& effect : analysis.effects)
    if (effect.called_for) json["effects_called_for"].push_back(to_string(effect.effect));
  json["effects"] = to_json(analysis.effects);
  json["bounce_bound"] = to_json(analysis.bounce_bound);
  json["analysis_seconds"] = analysis.seconds;
}

SceneAnalysis analysis_of(const Json& json) {
  SceneAnalysis analysis;
  read_field(json, "key", analysis.key);
  analysis.geometry = geometry_report_of(object_field(json, "geometry"));
  analysis.effects = evidence_of(object_field(json, "effects"));
  analysis.bounce_bound = bound_record_of(object_field(json, "bounce_bound"));
  read_field(json, "analysis_seconds", analysis.seconds);
  return analysis;
}

StudySceneRecord scene_of(const Json& json) {
  StudySceneRecord scene;
  read_field(json, "name", scene.name);
  if (scene.name.empty()) throw InputError("scenes", "has a scene without a name");
  read_field(json, "file", scene.file);
  read_field(json, "skipped", scene.skipped);
  read_field(json, "camera", scene.camera);
  if (field(json, "key")) scene.analysis = analysis_of(json);
  scene.exposure = exposure_in(json);
  read_field(json, "resolution", scene.resolution);
  read_field(json, "reference", scene.reference);
  read_field(json, "message", scene.message);
  return scene;
}

StudyRunRecord run_of(const Json& json) {
  StudyRunRecord run;
  read_field(json, "id", run.id);
  read_field(json, "scene", run.scene);
  read_field(json, "method", run.method);
  run.label = run.id.empty() ? run.method : run.id;
  read_field(json, "label", run.label);
  run.parameters = parameters_of(object_field(json, "parameters"));
  read_field(json, "lights", run.lights);
  run.process = process_of_entry(json);
  run.folder = "runs/" + run.id;
  read_field(json, "folder", run.folder);
  return run;
}

/// Each entry of a list of objects, read; nothing where the list is absent.
template <class Read>
auto list_in(const Json& json, const char* name, const Read& read) {
  std::vector<decltype(read(json))> records;
  const Json* list = field(json, name);
  if (!list) return records;
  if (!list->is_array()) throw InputError(name, "is not a list");
  for (const Json& entry : *list) {
    if (!entry.is_object()) throw InputError(name, "is not a list of objects");
    records.push_back(read(entry));
  }
  return records;
}

StudyRecord study_record_of(const Json& json) {
  const Json* version = field(json, "gibench_study");
  if (!version || *version != 1) throw InputError("gibench_study", "is not 1");
  StudyRecord record;
  read_field(json, "name", record.name);
  record.origin = origin_of(json);
  read_field(json, "created", record.created);
  read_field(json, "seed", record.seed);
  read_field(json, "threads", record.threads);
  read_field(json, "jobs", record.jobs);
  if (const Json* study = field(json, "study")) record.study = std::make_shared<const nlohmann::json>(*study);
  record.scenes = list_in(json, "scenes", scene_of);
  record.runs = list_in(json, "runs", run_of);
  record.relights = list_in(json, "relights", run_of);
  record.damaged = seal_of(json) == Seal::broken;
  return record;
}

}  // namespace

Json to_json(const StudyRunRecord& run) {
  Json json{{"id", run.id}, {"label", run.label}, {"scene", run.scene}, {"method", run.method}};
  json["parameters"] = to_json(run.parameters);
  write_field(json, "lights", run.lights);
  add_to_entry(run.process, json);
  json["folder"] = run.folder;
  return json;
}

Json to_json(const StudySceneRecord& scene) {
  Json json{{"name", scene.name}, {"file", scene.file}};
  write_field(json, "skipped", scene.skipped);
  write_field(json, "camera", scene.camera);
  if (scene.analysis) json["key"] = scene.analysis->key;
  write_exposure(json, scene.exposure);
  write_field(json, "resolution", scene.resolution);
  if (scene.analysis) write_analysis(json, *scene.analysis);
  write_field(json, "reference", scene.reference);
  if (!scene.message.empty()) json["message"] = scene.message;
  return json;
}

Json to_json(const StudyRecord& record) {
  Json json{{"gibench_study", 1}, {"name", record.name}};
  write_origin(json, record.origin);
  json["created"] = record.created;
  json["seed"] = record.seed;
  json["threads"] = record.threads;
  json["jobs"] = record.jobs;
  if (record.study) json["study"] = Json(*record.study);
  const auto write_list = [&json](const char* name, const auto& entries) {
    json[name] = Json::array();
    for (const auto& entry : entries) json[name].push_back(to_json(entry));
  };
  write_list("scenes", record.scenes);
  write_list("runs", record.runs);
  write_list("relights", record.relights);
  return json;
}

StudyRecord read_study_record(const std::filesystem::path& file) {
  return read_record(file, "a study manifest of version 1 (\"gibench_study\": 1)", study_record_of);
}

}  // namespace gibench
