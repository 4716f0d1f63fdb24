/// The interface of every transport method: what a method implements, and nothing else.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "common/effects/effect_plan.h"
#include "common/effects/plan_paths.h"
#include "common/lighting/direct_light.h"
#include "common/method/capabilities.h"
#include "common/method/shading.h"
#include "common/method/stage_report.h"
#include "common/method/task.h"
#include "common/ray/world.h"

namespace gibench {

/// The lights that the plan leaves.
struct PlannedLights {
  const Lighting& lighting;   ///< for the length of the call
  const DirectLight& direct;  ///< the shared evaluator of these lights under the plan; stays until the next stage begins
};

/// Called by a MethodSession, which keeps the order of the calls and whatever several methods would do alike: it checks
/// sizes, takes the time and the counts, and asks for nothing that the plan makes needless. Where the plan leaves a
/// method nothing to do, its stages are not called at all.
///
/// Each stage fills `termination` and `message` of its report; the rest of the report is the session's. A stage that
/// finds its task cancelled returns early, whatever it has.
class TransportMethod {
 public:
  virtual ~TransportMethod() = default;

  virtual Capabilities capabilities() const noexcept = 0;
  /// Why this method cannot work on this scene, in one line; asked before time is spent.
  virtual std::optional<std::string> refusal(const Scene&) const { return std::nullopt; }
  /// The light paths that shade() answers under a plan, between a light and the surface asked about, as an expression. By
  /// default those of the plan; where the method leaves direct light to the shared evaluator, that part with every lobe.
  virtual std::string light_paths(const EffectPlan& plan, const BounceRange& range) const;
  /// Bytes that the method holds between its stages, without the scene and the ray backend.
  virtual std::size_t bytes() const { return 0; }

  /// Geometry and materials only. The world stays until another takes its place in prepare() or edit(); the plan is for
  /// the length of the call and holds until then. May come again, for another world or plan.
  virtual void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) = 0;
  /// The lights; again without prepare() when they change.
  virtual void light(const PlannedLights& lights, Task& task, StageReport& report) = 0;
  /// After one edit of the scene: the world as it now is, planned anew, and its lights. By default prepare and light again.
  virtual void edit(const SceneEdit& edit, const World& after, const EffectPlan& plan, const PlannedLights& lights, Task& task,
                    StageReport& report);
  /// Writes every value that is asked for, of one sample at least.
  virtual void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport& report) const = 0;
};

}  // namespace gibench
