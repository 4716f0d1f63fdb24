/// The runner of a study: every scene's check, every reference and every run in a process of its own.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "bench/measure/model_limits.h"
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
  ModelLimits model_limits;
  Shard shard;  ///< runs whose place in the plan mod `of` is `index`
};

/// A folder runs/ID appears whole, with run.json in it, whether the run came to its end or not; the manifest is
/// collected from them. A finished run, a refusal and a time-out with the same key are kept while their files are as they were
/// written and their errors are of the references as they are now; a crash or a failure is tried again.
class StudyRunner {
 public:
  StudyRunner(const Study& study, StudySettings settings, const WorkOptions& common);
  ~StudyRunner();

  /// Throws InputError for a scene that is wrong, WorkError where the user asked to stop, which says what was kept. What runs do
  /// is recorded.
  void run();
  /// The study's record as it stands.
  StudyRecord record() const;
  /// References that were not made and runs that failed or crashed, a line each.
  const std::vector<std::string>& not_done() const { return not_done_; }

 private:
  struct SceneState {
    std::optional<CheckRecord> check;          ///< empty: not checked yet
    std::optional<std::string> skipped;        ///< why its runs are left out
    std::optional<ReferenceRecord> reference;  ///< of all paths, as it lies in its folder; empty: none
    std::string reference_message;             ///< why there is none
    // What errors are taken against.
    bool references_known = false;                   ///< the rest is known
    std::optional<std::string> state;                ///< of the reference of all paths; empty: there is none now
    std::optional<std::string> earlier;              ///< of the one that finished runs were held against, where there is none now
    std::map<std::size_t, std::string> paths;        ///< by variant: its light paths, where they are not all
    std::map<std::string, std::string> path_states;  ///< by light paths: of their reference, where there is one
  };
  /// The end of a process that made a reference.
  struct MadeReference {
    ChildResult child;
    std::string reason;                ///< why there is none
    std::optional<std::string> state;  ///< empty: none
  };

  void run_stages();
  void check_scenes();
  void make_references();
  void make_reference(std::size_t scene);
  void make_path_references(std::size_t scene);
  /// In a process of its own; `out` is where to write it out, if anywhere. A damaged one is told.
  MadeReference make_stored(std::size_t scene, const MeasuringOptions& measuring, const std::filesystem::path& out);
  std::map<std::size_t, std::string> restricted_paths(std::size_t scene) const;
  std::optional<std::string> state_of_finished(std::size_t scene) const;
  std::optional<std::string> path_state(const PlannedRun& run) const;
  std::vector<std::string> reference_arguments(std::size_t scene, const MeasuringOptions& measuring) const;
  ChildLimits reference_limits() const;
  std::optional<ReferenceRecord> reference_if_there(const std::string& scene) const;
  void run_all();
  void run_one(const PlannedRun& run);
  void relight_one(const PlannedRelight& relight);
  /// Runs the child for the folder runs/ID unless what lies there is kept. `asked` holds what its record is to say of that.
  template <class Planned>
  void run_for(const Planned& planned, ProcessRecord asked,
               const std::function<std::vector<std::string>(const std::filesystem::path& made)>& arguments);
  void keep(const std::string& id, const ChildResult& child, ProcessRecord entry, const std::filesystem::path& made);
  /// Whether a record is of what is planned, held against the references as they are.
  bool is_current(const ProcessRecord& recorded, const PlannedRun& run) const;
  bool is_current(const ProcessRecord& recorded, const PlannedRelight& relight) const;
  /// The record of a result that need not be made again if its files are whole.
  template <class Planned>
  std::optional<ProcessRecord> finished(const Planned& planned) const;
  template <class Planned>
  bool is_kept(const Planned& planned) const;
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
  ChildResult child(std::vector<std::string> arguments, const ChildLimits& limits) const;
  void write_manifest() const;
  void tell(const std::string& line);
  void tell_not_done(const std::string& line);

  const Study& study_;
  StudySettings settings_;
  WorkOptions common_;
  StudyFolders folders_;
  std::vector<PlannedRun> runs_;
  std::vector<PlannedRelight> relights_;  ///< after the runs in the order of the shards
  std::vector<SceneState> scenes_;
  std::shared_ptr<Progress> progress_;
  std::string created_;
  std::vector<std::string> not_done_;
  std::mutex terminal_;  ///< and of not_done_
  mutable std::mutex manifest_;
  std::atomic<std::size_t> finished_{0};  ///< runs of this process
  std::size_t due_ = 0;
  mutable std::atomic<unsigned> children_{0};  ///< each has files of its own
};

}  // namespace gibench
