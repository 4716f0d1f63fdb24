#include "common/method/method.h"

namespace gibench {

std::string TransportMethod::light_paths(const EffectPlan& plan, const BounceRange& range) const {
  return light_paths_of(plan, !capabilities().direct, range);
}

void TransportMethod::edit(const SceneEdit&, const World& after, const EffectPlan& plan, const PlannedLights& lights, Task& task,
                           StageReport& report) {
  prepare(after, plan, task, report);
  if (succeeded(report.termination) && !task.cancelled()) light(lights, task, report);
}

}  // namespace gibench
