/// The runner of a study: every scene's check, every reference and every run in a process of its own.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/measure/work_options.h"
#include "bench/record/check_record.h"
#include "bench/record/reference_record.h"
#include "bench/record/study_record.h"
#include "bench/study/child_process.h"
#include "bench/study/shard.h"
#include "bench/study/study_file.h"
#include "bench/study/study_plan.h"

namespace gibench {

struct StudySettings {
  std::filesystem::path out;
  bool force = false;  ///< redo what is finished
  int jobs = 1;        ///< processes at a time
  Shard shard;         ///< runs whose place in the plan mod `of` is `index`
};

/// A folder runs/ID appears whole, with run.json in it, whether the run came to its end or not; the manifest is
/// collected from them. A finished run, a refusal and a time-out with the same key are kept, a crash or a failure is
/// tried again.
class StudyRunner {
 public:
  StudyRunner(const Study& study, StudySettings settings, const WorkOptions& common);
  ~StudyRunner();

  /// Throws InputError for a scene that is wrong, WorkError where the user asked to stop, which says what was kept. What runs do
  /// is recorded.
  void run();
  /// The study's record as it stands.
  StudyRecord record() const;

 private:
  struct SceneState {
    std::optional<CheckRecord> check;          ///< empty: not checked yet
    std::optional<std::string> skipped;        ///< why its runs are left out
    std::optional<ReferenceRecord> reference;  ///< empty: none
    std::string reference_message;             ///< why there is none
  };

  void run_stages();
  void check_scenes();
  void make_references();
  void make_reference(std::size_t scene);
  void make_path_references(std::size_t scene);
  std::set<std::string> restricted_paths(std::size_t scene) const;
  std::vector<std::string> reference_arguments(std::size_t scene, const MeasuringOptions& measuring) const;
  ChildLimits reference_limits() const;
  std::optional<ReferenceRecord> reference_if_there(const std::string& scene) const;
  void run_all();
  void run_one(const PlannedRun& run);
  void relight_one(const PlannedRelight& relight);
  /// Runs the child for the folder runs/ID unless it holds what this key made.
  void run_for(const std::string& id, const std::string& key,
               const std::function<std::vector<std::string>(const std::filesystem::path& made)>& arguments);
  void keep(const std::string& id, const ChildResult& child, const std::string& key, const std::filesystem::path& made);
  bool is_kept(const std::string& id, const std::string& key) const;
  bool is_own(std::size_t place) const;  ///< of this shard
  bool is_due(std::size_t place) const;  ///< of this shard, on a scene that is there
  /// For the user who stopped the study: what is there already, and how to get the rest.
  std::string describe_kept() const;
  std::string key_of(const PlannedRun& run) const;
  std::string key_of(const PlannedRelight& relight) const;
  StudySceneRecord record_of_scene(std::size_t scene) const;
  StudyRunRecord record_of(const PlannedRun& run) const;
  StudyRunRecord record_of(const PlannedRelight& relight) const;
  /// `key_of(planned)`, where its scene was checked, tells whether what lies in its folder is of this study.
  template <class Planned>
  ProcessRecord outcome_of(const Planned& planned, std::size_t scene) const;
  ChildResult child(std::vector<std::string> arguments, const ChildLimits& limits, const std::string& name) const;
  void write_manifest() const;
  void tell(const std::string& line);

  const Study& study_;
  StudySettings settings_;
  WorkOptions common_;
  StudyFolders folders_;
  std::vector<PlannedRun> runs_;
  std::vector<PlannedRelight> relights_;  ///< after the runs in the order of the shards
  std::vector<SceneState> scenes_;
  std::shared_ptr<Progress> progress_;
  std::string created_;
  std::mutex terminal_;
  mutable std::mutex manifest_;
  std::atomic<std::size_t> finished_{0};  ///< runs of this process
  std::size_t due_ = 0;
};

}  // namespace gibench
