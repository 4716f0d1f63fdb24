/// One method on one scene: planned, prepared, lit, asked at the measuring points.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure/loaded_scene.h"
#include "bench/measure/measuring.h"
#include "bench/measure/plan_options.h"
#include "bench/measure/run_log.h"
#include "bench/measure/seed_answers.h"
#include "bench/measure/work_options.h"
#include "bench/record/pair_record.h"
#include "bench/record/run_record.h"
#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "common/method/method_session.h"

namespace gibench {

/// Which method, how set.
struct MethodChoice {
  const MethodEntry* entry = nullptr;
  Parameters parameters;
};

/// The method of this name. Throws InputError, the known ones listed; `place` is where it is named.
const MethodEntry& method_named(const std::string& name, const std::string& place);

/// `settings` are "name=value" texts as of --set, which override those of the preset, if one is named. Throws InputError for what
/// is unknown, out of range or not a setting.
MethodChoice choose_method(const std::string& name, const std::vector<std::string>& settings, const std::string& preset = {});

/// Throws InputError, the methods that do listed, for a method whose capabilities do not say that it relights.
/// `place` is where the method is named.
void require_relighting(const MethodChoice& choice, const std::string& place = "--method");

/// Throws MethodRefusal for a method that does not answer irradiance, in which methods are compared at surface samples.
void require_irradiance(const MethodChoice& choice);

/// A method cannot work on a scene, and says why.
class MethodRefusal : public WorkError {
 public:
  using WorkError::WorkError;
};

/// What a method is to simulate on a scene and the paths that this means.
struct PlannedMethod {
  std::unique_ptr<MethodSession> method;
  EffectPlan plan;
  std::string light_paths;
  bool complete = false;  ///< all paths that the scene has, of the bounces asked for
};
/// Throws InputError for light paths given to a method that cannot choose its paths.
PlannedMethod plan_method(const SceneEffects& effects, const MethodChoice& choice, const std::string& light_paths = {});

/// A method that is ready to be asked. Throws MethodRefusal, and WorkError for a stage that failed.
struct LitMethod : PlannedMethod {
  std::vector<StageRecord> stages;  ///< prepare and light

  /// Whether what a camera sees behind the scene belongs to the answer.
  bool shows_background() const;
};
LitMethod prepare_and_light(const World& world, const MethodChoice& choice, const PlanOptions& options,
                            std::optional<int> bounces, Task& task, RunLog& log);

/// A task of these options, with cancellation, and progress under a title that names what works.
Task make_task(const WorkOptions& common, const std::string& title);

struct RunOutcome {
  RunRecord record;
  Answers surface;
  std::optional<Answers> image;
  std::vector<SeedAnswers> other_seeds = {};  ///< what the same run answers with the seeds after its own
  std::optional<PairRecord> pairs = {};       ///< of its errors, where there are some
};
RunOutcome run_method(const LoadedScene& scene, const MethodChoice& choice, const MeasuringOptions& measuring,
                      const PlanOptions& options, const WorkOptions& common, RunLog& log);

/// Runs the method `count` − 1 times more, prepared and lit anew with each of the seeds after that of `common`, and keeps the
/// answers. Their time and counters are in no record.
void add_other_seeds(const LoadedScene& scene, const MethodChoice& choice, const MeasuringOptions& measuring,
                     const PlanOptions& options, const WorkOptions& common, int count, RunLog& log, RunOutcome& outcome);

}  // namespace gibench
