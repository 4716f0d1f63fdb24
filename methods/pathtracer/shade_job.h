/// One request answered: its paths cut into units, traced in parallel, summed in a fixed order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/method.h"
#include "methods/pathtracer/path_batch.h"
#include "methods/pathtracer/replicate_sums.h"

namespace gibench::pathtracer {

/// Path p of a value (p from Settings::first_sample on) is number p div R of replicate p mod R. A unit is a batch: all paths of
/// as many values as it holds, or some paths of one value that has more. All sizes depend on the request and the settings
/// alone, never on the threads; none grows with the number of paths.
class ShadeJob {
 public:
  ShadeJob(const PathScene& scene, const SceneLights& lights, const PathRules& rules, const Settings& settings,
           const EffectPlan& plan, const ShadeRequest& request, const ShadeAnswer& answer, Task& task);

  /// Writes the answer; stops early, values unwritten, once the task is cancelled.
  void run();

 private:
  /// Paths [first_path, first_path + paths) of each of the values [first_value, first_value + values).
  struct Unit {
    std::uint64_t first_value, values, first_path, paths;
  };
  /// One thread's workspace.
  struct Workspace {
    std::vector<AskedSurface> asked;
    std::vector<PathStart> starts;
    std::vector<PathLight> light;
    std::vector<ReplicateSum> sums;
  };

  bool cuts_values() const { return units_per_value_ > 1; }
  Unit unit(std::uint64_t number) const;
  void run_round(std::uint64_t first_unit, std::uint64_t units);
  void trace(const Unit& unit, PathBatch& batch, Workspace& work) const;
  void add_up(const Unit& unit, std::span<const PathLight> light, std::span<ReplicateSum> sums) const;
  void join(std::uint64_t first_unit, std::uint64_t units);
  AskedSurface asked_at(std::uint64_t value) const;
  void write(std::uint64_t value, const AskedSurface& asked, std::span<const ReplicateSum> replicates) const;

  const PathScene& scene_;
  const SceneLights& lights_;
  const PathRules& rules_;
  const Settings& settings_;
  const ShadeRequest& request_;
  const ShadeAnswer& answer_;
  Task& task_;
  PathBounds bounds_;
  std::uint64_t values_, units_per_value_, values_per_unit_, paths_per_unit_, units_;
  std::size_t replicates_;               ///< of a value, those with paths
  std::vector<ReplicateSum> unit_sums_;  ///< where values are cut: those of one round's units, replicate by replicate
  std::vector<ReplicateSum> joined_;     ///< likewise: of the value whose units are being joined
};

}  // namespace gibench::pathtracer
