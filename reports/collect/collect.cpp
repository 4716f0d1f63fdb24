#include "reports/collect/collect.h"

#include <fmt/ranges.h>

#include <set>

#include "bench/record/checksums.h"
#include "bench/record/reference_record.h"
#include "bench/record/relight_record.h"
#include "bench/record/study_record.h"
#include "common/core/error.h"
#include "reports/collect/compare_runs.h"
#include "reports/collect/facts.h"
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

std::string bounces_text(const BoundRecord& bound) {
  return (bound.most ? exact(*bound.most) : std::string("not bounded")) + " (for " + exact(bound.tolerance) + " of the light)";
}

/// Names the file and the remedy.
std::string damage_text(const Study& study, const fs::path& folder, const DamagedFile& damaged, const std::string& remedy) {
  const std::string file = (folder / damaged.name).string();
  return without_folder(study, file + ": " + damaged.problem + "; run the study again: " + remedy);
}

StudyScene scene_of(const StudySceneRecord& record, Study& study) {
  StudyScene scene;
  scene.name = record.name;
  scene.skipped = record.skipped;
  scene.exposure = record.exposure.value_or(Exposure{}).value;
  if (record.analysis) {
    scene.effects = record.analysis->effects;
    scene.bounce_bound = record.analysis->bounce_bound.evidence;
    scene.bounces = bounces_text(record.analysis->bounce_bound);
  }
  scene.facts = facts_of(to_json(record), {"name", "skipped", "exposure", "message", "effects"});
  scene.reference_folder = inside(study.folder, record.reference.value_or("references/" + scene.name));
  const fs::path file = scene.reference_folder / reference_file;
  if (scene.reference_folder.empty() || !fs::exists(file)) return scene;
  try {
    const ReferenceRecord reference = read_reference_record(file);
    scene.reference = facts_of(to_json(reference), {"files", "checksum"});
    for (const DamagedFile& damaged : damaged_files(scene.reference_folder, reference.files))
      study.warnings.push_back(damage_text(study, scene.reference_folder, damaged, "it writes the picture again"));
  } catch (const InputError& error) {
    study.warnings.push_back(without_folder(study, error.what()));
  }
  return scene;
}

/// What a run and a relighting have in common.
template <class Outcome>
Outcome outcome_of(const StudyRunRecord& record) {
  Outcome outcome;
  outcome.id = record.id, outcome.scene = record.scene, outcome.method = record.method, outcome.label = record.label;
  outcome.parameters = facts_of(to_json(record.parameters));
  outcome.status = record.process.status;
  outcome.message = record.process.message;
  return outcome;
}

/// Reads the record of `outcome`; one that cannot be used makes it a failure that says why, with a line in the warnings.
template <class Outcome, class Read>
void read_or_fail(const std::string& what, Outcome& outcome, Study& study, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string problem = without_folder(study, error.what());
    study.warnings.push_back(what + " " + outcome.id + ": " + problem);
    if (outcome.status != RunStatus::done) return;
    outcome.status = RunStatus::failed;
    outcome.message = "its record cannot be used: " + problem;
  }
}

/// Files that changed since the study wrote them are told; without its record as it was written, `what` is a failure.
template <class Outcome>
void check_files(const std::string& what, const StudyRunRecord& record, const std::string& its_record, Outcome& outcome,
                 Study& study) {
  const fs::path folder = inside(study.folder, record.folder);
  if (folder.empty() || outcome.status != RunStatus::done) return;
  for (const DamagedFile& damaged : damaged_files(folder, record.process.files)) {
    const std::string problem = damage_text(study, folder, damaged, "it does this again");
    study.warnings.push_back(what + " " + outcome.id + ": " + problem);
    if (damaged.name != its_record) continue;
    outcome = outcome_of<Outcome>(record);
    outcome.status = RunStatus::failed;
    outcome.message = "its record cannot be used: " + problem;
  }
}

StudyRun run_of(const StudyRunRecord& record, Study& study) {
  auto run = outcome_of<StudyRun>(record);
  const fs::path folder = inside(study.folder, record.folder), file = folder / result_file;
  const bool there = !folder.empty() && fs::exists(file);
  if (there || run.status == RunStatus::done) read_or_fail("run", run, study, [&] { read_result(file, run); });
  check_files("run", record, result_file, run, study);
  run.exit_code = record.process.exit_code;
  run.wall_seconds = record.process.wall_seconds;
  if (record.process.peak_bytes) run.peak_bytes = record.process.peak_bytes;
  run.folder = folder;
  return run;
}

StudyRelight relight_of(const StudyRunRecord& record, Study& study) {
  auto relight = outcome_of<StudyRelight>(record);
  const fs::path file = inside(study.folder, record.folder) / relight_file;
  if (relight.status == RunStatus::done) read_or_fail("relighting", relight, study, [&] { read_relight(file, relight); });
  check_files("relighting", record, relight_file, relight, study);
  relight.lights = record.lights.value_or("");
  return relight;
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

Study collect_study(const fs::path& folder, const MayGoOn& may_go_on) {
  const fs::path file = folder / manifest_file;
  const std::string remedy = "give the folder that `gibench study STUDY.json --out DIR` wrote";
  if (!fs::is_directory(folder)) throw InputError(folder.string(), "is not a folder", remedy);
  if (!fs::exists(file)) throw InputError(folder.string(), "holds no manifest.json, so it is not a study", remedy);
  const StudyRecord record = read_study_record(file);

  Study study;
  study.folder = folder;
  study.name = record.name.empty() ? folder.filename().string() : record.name;
  study.version = record.origin.version;
  study.commit = record.origin.commit;
  study.created = record.created;
  study.machine = facts_of(to_json(record.origin.machine));
  study.settings = {
      {"seed", std::to_string(record.seed)}, {"threads", std::to_string(record.threads)}, {"jobs", std::to_string(record.jobs)}};
  if (record.damaged)
    study.warnings.emplace_back(std::string(manifest_file) +
                                ": is not as it was written; run the study again: it writes its manifest anew");
  for (const StudySceneRecord& scene : record.scenes) study.scenes.push_back(scene_of(scene, study));
  for (const StudyRunRecord& run : record.runs) {
    may_go_on();
    study.runs.push_back(run_of(run, study));
  }
  list_missing_scenes(study);
  if (const auto machines = study.machines(); machines.size() > 1)
    study.warnings.push_back(
        fmt::format("the runs were measured on {} machines ({}): their seconds do not compare, and a speed-up "
                    "is told only over path tracing on a run's own machine",
                    machines.size(), fmt::join(machines, "; ")));
  for (const StudyRunRecord& relight : record.relights) {
    may_go_on();
    study.relights.push_back(relight_of(relight, study));
  }
  compare_runs(study, may_go_on);
  return study;
}

}  // namespace gibench::report
