#include "reports/collect/collect.h"

#include <algorithm>
#include <set>

#include "bench/record/json_fields.h"
#include "bench/record/reference_record.h"
#include "bench/record/relight_record.h"
#include "common/core/enum_names.h"
#include "common/core/error.h"
#include "reports/collect/json_reading.h"
#include "reports/tables/format.h"

namespace gibench::report {
namespace {

namespace fs = std::filesystem;

/// A path inside the study folder, or empty for one that leads out of it.
fs::path inside(const fs::path& folder, const std::string& relative) {
  const fs::path path(relative);
  if (relative.empty() || path.is_absolute()) return {};
  for (const auto& part : path)
    if (part == "..") return {};
  return folder / path;
}

float exposure_of(const Json& scene) {
  if (const auto value = number_at(scene, "exposure")) return static_cast<float>(*value);
  return static_cast<float>(number_at(object_at(scene, "exposure"), "value").value_or(0.0));
}

std::optional<std::string> skip_reason(const Json& scene) {
  if (const auto why = text_at(scene, "skipped")) return why;
  const auto found = scene.find("skipped");
  if (found == scene.end() || !found->is_boolean() || !found->get<bool>()) return std::nullopt;
  return text_at(scene, "message").value_or("left out");
}

std::vector<SceneEffect> scene_effects_of(const Json& scene) {
  std::vector<SceneEffect> effects;
  if (const auto list = scene.find("effects"); list != scene.end() && list->is_array())
    for (const Json& item : *list) {
      const auto called_for = item.is_object() ? item.find("called_for") : item.end();
      if (called_for == item.end() || !called_for->is_boolean()) continue;
      effects.push_back({text_at(item, "effect").value_or(""), text_at(item, "evidence").value_or(""), called_for->get<bool>()});
    }
  return effects;
}

StudyScene scene_of(const Json& entry, Study& study) {
  StudyScene scene;
  scene.name = text_at(entry, "name").value_or("");
  if (scene.name.empty()) throw InputError((study.folder / "manifest.json").string(), "has a scene without a name");
  scene.skipped = skip_reason(entry);
  scene.exposure = exposure_of(entry);
  scene.effects = scene_effects_of(entry);
  const Json& bound = object_at(entry, "bounce_bound");
  scene.bounce_bound = text_at(bound, "evidence").value_or("");
  const auto most = number_at(bound, "most"), tolerance = number_at(bound, "tolerance");
  if (tolerance)
    scene.bounces = (most ? exact(*most) : std::string("not bounded")) + " (for " + exact(*tolerance) + " of the light)";
  scene.facts = facts_of(entry, {"name", "skipped", "exposure", "message", "effects"});
  scene.reference_folder = inside(study.folder, text_at(entry, "reference").value_or("references/" + scene.name));
  const fs::path file = scene.reference_folder / reference_file;
  if (scene.reference_folder.empty() || !fs::exists(file)) return scene;
  try {
    scene.reference = facts_of(to_json(read_reference_record(file)));
  } catch (const InputError& error) {
    study.warnings.push_back(without_folder(study, error.what()));
  }
  return scene;
}

StudyRun run_of(const Json& entry, Study& study) {
  StudyRun run;
  run.id = text_at(entry, "id").value_or("");
  run.scene = text_at(entry, "scene").value_or("");
  run.method = text_at(entry, "method").value_or("");
  run.label = text_at(entry, "label").value_or(run.id.empty() ? run.method : run.id);
  run.parameters = facts_of(object_at(entry, "parameters"));
  run.message = text_at(entry, "message").value_or("");
  if (const auto code = number_at(entry, "exit_code")) run.exit_code = static_cast<int>(*code);
  run.wall_seconds = number_at(entry, "wall_seconds");
  run.peak_bytes = count_at(entry, "peak_bytes");
  run.folder = inside(study.folder, text_at(entry, "folder").value_or("runs/" + run.id));

  const std::string status = text_at(entry, "status").value_or("");
  if (const auto known = find_named(all_run_statuses, status)) run.status = *known;
  else run.message = "unknown status '" + status + "' in the manifest" + (run.message.empty() ? "" : "; " + run.message);

  const fs::path file = run.folder / result_file;
  const bool there = !run.folder.empty() && fs::exists(file);
  if (!there && run.status != RunStatus::done) return run;
  try {
    read_result(file, run);
  } catch (const InputError& error) {
    const std::string problem = without_folder(study, error.what());
    study.warnings.push_back("run " + run.id + ": " + problem);
    if (run.status == RunStatus::done) {
      run.status = RunStatus::failed;
      run.message = "its record cannot be used: " + problem;
    }
  }
  return run;
}

StudyRelight relight_of(const Json& entry, Study& study) {
  StudyRelight relight;
  relight.id = text_at(entry, "id").value_or("");
  relight.scene = text_at(entry, "scene").value_or("");
  relight.method = text_at(entry, "method").value_or("");
  relight.label = text_at(entry, "label").value_or(relight.method);
  relight.lights = text_at(entry, "lights").value_or("");
  relight.parameters = facts_of(object_at(entry, "parameters"));
  relight.message = text_at(entry, "message").value_or("");
  relight.status = find_named(all_run_statuses, text_at(entry, "status").value_or("")).value_or(RunStatus::failed);
  if (relight.status != RunStatus::done) return relight;
  const fs::path folder = inside(study.folder, text_at(entry, "folder").value_or("runs/" + relight.id));
  try {
    read_relight(folder / relight_file, relight);
  } catch (const InputError& error) {
    relight.status = RunStatus::failed;
    relight.message = "its record cannot be used: " + without_folder(study, error.what());
    study.warnings.push_back("relighting " + relight.id + ": " + without_folder(study, error.what()));
  }
  return relight;
}

/// A list of objects; empty where it is absent. Throws InputError where it is not a list.
Json entries(const Json& manifest, const std::string& name, const fs::path& file) {
  const Json list = manifest.value(name, Json::array());
  if (!list.is_array() || !std::all_of(list.begin(), list.end(), [](const Json& item) { return item.is_object(); }))
    throw InputError(file.string(), "\"" + name + "\" is not a list of objects", "it is damaged: run the study again");
  return list;
}

/// Runs name scenes; one that the manifest does not list is listed, so that no result is lost.
void list_missing_scenes(Study& study) {
  std::set<std::string> known;
  for (const StudyScene& scene : study.scenes) known.insert(scene.name);
  for (const StudyRun& run : study.runs) {
    if (!known.insert(run.scene).second) continue;
    StudyScene scene;
    scene.name = run.scene;
    scene.reference_folder = inside(study.folder, "references/" + run.scene);
    study.scenes.push_back(std::move(scene));
    study.warnings.push_back("run " + run.id + ": its scene '" + run.scene + "' is not in the manifest's list");
  }
}

}  // namespace

Study collect_study(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  const std::string remedy = "give the folder that `gibench study STUDY.json --out DIR` wrote";
  if (!fs::is_directory(folder)) throw InputError(folder.string(), "is not a folder", remedy);
  if (!fs::exists(file)) throw InputError(folder.string(), "holds no manifest.json, so it is not a study", remedy);
  const Json manifest = read_json_file(file);
  if (!manifest.is_object() || count_at(manifest, "gibench_study") != std::uint64_t{1})
    throw InputError(file.string(), "is not a study manifest of version 1 (\"gibench_study\": 1)", remedy);

  Study study;
  study.folder = folder;
  study.name = text_at(manifest, "name").value_or(folder.filename().string());
  study.version = text_at(manifest, "version").value_or("");
  study.commit = text_at(manifest, "commit").value_or("");
  study.created = text_at(manifest, "created").value_or("");
  study.machine = facts_of(object_at(manifest, "machine"));
  study.settings = facts_of(
      manifest, {"gibench_study", "name", "version", "commit", "created", "machine", "scenes", "runs", "relights", "study"});
  for (const Json& scene : entries(manifest, "scenes", file)) study.scenes.push_back(scene_of(scene, study));
  for (const Json& run : entries(manifest, "runs", file)) study.runs.push_back(run_of(run, study));
  list_missing_scenes(study);
  for (const Json& relight : entries(manifest, "relights", file)) study.relights.push_back(relight_of(relight, study));
  return study;
}

}  // namespace gibench::report
