/// The runs of a study and where their results lie.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measure/work_options.h"
#include "bench/record/study_record.h"
#include "bench/study/shard.h"
#include "bench/study/study_file.h"

namespace gibench {

struct PlannedRun {
  std::string id;                      ///< name of its folder, unique in the study
  std::size_t scene = 0, variant = 0;  ///< places in the study
};

struct PlannedRelight {
  std::string id;           ///< name of its folder, unique in the study
  std::size_t relight = 0;  ///< place in the study
};

/// Every variant on each of its scenes, scene by scene.
std::vector<PlannedRun> plan_runs(const Study& study);
std::vector<PlannedRelight> plan_relights(const Study& study);

/// The key of a finished run: if it differs, the result is not that of this study any more. Hash of the
/// program's version and commit, scene, method, parameters, seed, threads, and where it is measured. What references its errors
/// were taken against stands beside the key.
std::string run_key(const Study& study, const PlannedRun& run, const WorkOptions& common, const std::string& scene_key);

/// The same of a relighting; `lights` is the text of its file of moving lights.
std::string relight_key(const Study& study, const StudyRelight& relight, const WorkOptions& common, const std::string& scene_key,
                        const std::string& lights);

/// The folders of a study's results.
struct StudyFolders {
  std::filesystem::path root;
  Shard shard;
  std::filesystem::path manifest() const { return root / manifest_file; }
  std::filesystem::path run(const std::string& id) const { return root / "runs" / id; }
  std::filesystem::path reference(const std::string& scene) const { return root / "references" / scene; }
  std::filesystem::path store() const { return root / "references" / "store"; }
  /// Of this shard's processes.
  std::filesystem::path scratch() const { return root / ("scratch-" + std::to_string(shard.index)); }
  /// Where a folder is made that is to be `target`: beside it, this shard's own.
  std::filesystem::path made_beside(std::filesystem::path target) const;
};

/// Removes a folder from made_beside(), with what a process that was killed on the way left of it.
void remove_made(const std::filesystem::path& made);

/// The options after `gibench run|check SCENE` that say what may be simulated.
std::vector<std::string> plan_arguments(const PlanOptions& plan);

}  // namespace gibench
