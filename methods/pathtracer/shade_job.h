/// One request answered: its values cut into units of paths, traced in parallel, summed in a fixed order.
#pragma once

#include <cstdint>
#include <vector>

#include "common/method/method.h"
#include "methods/pathtracer/path_batch.h"
#include "methods/pathtracer/replicate_sums.h"

namespace gibench::pathtracer {

/// Path p of a value (p from Settings::first_sample on) is number p div R of replicate p mod R. All sizes depend on the
/// request and the settings alone, never on the threads.
class ShadeJob {
 public:
  ShadeJob(const PathScene& scene, const SceneLights& lights, const PathRules& rules, const Settings& settings,
           const EffectPlan& plan, const ShadeRequest& request, const ShadeAnswer& answer, Task& task);

  /// Writes the answer; stops early, values unwritten, once the task is cancelled.
  void run();

 private:
  void run_tile(std::uint64_t first_value, std::uint64_t values);
  void trace_unit(std::uint64_t value, std::uint64_t unit, PathBatch& batch, ReplicateSum* sums) const;
  void write(std::uint64_t value, const ReplicateSum* sums, std::vector<ReplicateSum>& replicates) const;

  const PathScene& scene_;
  const SceneLights& lights_;
  const PathRules& rules_;
  const Settings& settings_;
  const ShadeRequest& request_;
  const ShadeAnswer& answer_;
  Task& task_;
  PathBounds bounds_;
  std::uint64_t units_per_value_;
  std::vector<ReplicateSum> sums_;  ///< of one tile: values × units × replicates
};

}  // namespace gibench::pathtracer
