/// Making references: the reference method in independent replicates, extended in rounds.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "bench/measure/loaded_scene.h"
#include "bench/measure/measuring.h"
#include "bench/measure/work_options.h"
#include "bench/record/reference_facts.h"
#include "common/reference/reference_store.h"

namespace gibench {

/// The method whose answers are the reference, and its parameters that say which samples each replicate takes.
struct ReferenceMethod {
  static constexpr const char* name = "pathtracer";
  static constexpr const char* samples = "samples";            ///< how many, over its own replicates: here one
  static constexpr const char* first_sample = "first_sample";  ///< the first one's index: what came before is not repeated
  /// Replicates of its own: one, as each replicate of the reference is one sequence, stratified as a whole.
  static constexpr const char* replicates = "replicates";
};

/// Which replicates of how many.
struct ReplicaSet {
  int count = 8;          ///< replicates of the whole reference
  int shard = 0, of = 1;  ///< this process makes those r with r mod of = shard
  int first = 0;          ///< number of the first one: others than these are independent of them

  int own() const { return (count - shard + of - 1) / of; }
};

/// How far a reference is to go.
struct ReferenceGoal {
  std::uint64_t samples_per_replica = 0;                   ///< paths per value in each; with a target: at most
  std::optional<std::uint64_t> image_samples_per_replica;  ///< at most so many of them for each pixel; empty: as many
  std::optional<double> target_error;                      ///< relative standard error of the indirect light at which to stop
};

/// The error that a target is one of: pixels with a number of paths of their own are not its matter.
double aimed_error(const ReferenceGoal& goal, const ReferenceFacts& facts);

/// Continues `reference` (empty replicas: begins it) with rounds that at most double its samples until the goal is met.
/// `measuring` holds the bound and the light paths that its path class stands for.
/// `after_round` gets the state after every round: a whole reference, ready to be saved. Throws WorkError where the
/// method refuses the scene or a stage fails.
void extend_reference(const LoadedScene& scene, const MeasuringOptions& measuring, const ReplicaSet& set,
                      const ReferenceGoal& goal, const WorkOptions& common, Reference& reference,
                      const std::function<void(const Reference&)>& after_round);

/// Every value's paths per replicate come in whole camera rays: the next multiple of pixel_samples.
std::uint64_t whole_samples(std::uint64_t samples_per_replica, const ReferenceQuestion& question);

/// The replicates that one shard of `of` has: those r with r mod of = shard.
Reference shard_of(const Reference& whole, int shard, int of);
/// The whole out of its shards, in the order of the shards, all of one question. InputError where their numbers of replicates or
/// samples do not fit.
Reference merge_shards(const std::vector<Reference>& shards);

}  // namespace gibench
