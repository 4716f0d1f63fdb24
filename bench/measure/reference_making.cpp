#include "bench/measure/reference_making.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/measure/cancellation.h"
#include "bench/measure/reference_search.h"
#include "bench/measure/run_method.h"
#include "bench/record/reference_facts.h"
#include "common/core/error.h"
#include "common/core/random.h"
#include "common/reference/merge.h"

namespace gibench {

namespace {

constexpr std::uint64_t first_round = 16;  // paths per value and replicate
constexpr std::uint64_t replica_stage = 0x7265706c696361ULL;

/// Makes one replicate's estimates from `first` on; everything about it is keyed by its own seed.
class ReplicaMaker {
 public:
  ReplicaMaker(const LoadedScene& scene, const ReferenceQuestion& question, const MeasuringOptions& measuring,
               const WorkOptions& common)
      : scene_(scene),
        question_(question),
        bounces_(measuring.bounces),
        plan_{{}, 0.0, measuring.light_paths},
        common_(common),
        points_(measuring_points(*scene.world, question, common.threads)) {}

  /// Paths of one value from `first` to before `last`.
  struct Span {
    std::uint64_t first = 0, last = 0;

    std::uint64_t count() const { return last - first; }
  };

  Answers make_surface(int replica, const Span& paths) const {
    return answers(replica, paths.first, paths.count(),
                   [this](const LitMethod& lit, Task& task) { return shade_surface(*lit.method, points_, task); });
  }
  /// A pixel's paths are shared out among its camera rays.
  Answers make_image(int replica, const Span& paths) const {
    const auto per_pixel = static_cast<std::uint64_t>(question_.pixel_samples);
    return answers(replica, paths.first / per_pixel, paths.count() / per_pixel, [this](const LitMethod& lit, Task& task) {
      return shade_image(*lit.method, points_, lit.shows_background(), task);
    });
  }
  const MeasuringPoints& points() const { return points_; }

 private:
  template <class Shade>
  Answers answers(int replica, std::uint64_t first, std::uint64_t count, const Shade& shade) const {
    const MethodChoice choice = choose_method(ReferenceMethod::name, {fmt::format("{}={}", ReferenceMethod::samples, count),
                                                                      fmt::format("{}={}", ReferenceMethod::first_sample, first),
                                                                      fmt::format("{}=1", ReferenceMethod::replicates)});
    WorkOptions own = common_;
    own.seed = mix_keys(question_.seed, replica_stage, static_cast<std::uint64_t>(replica));
    own.quiet = true;
    RunLog log({}, true);
    Task task = make_task(own, {});
    const LitMethod lit = prepare_and_light(*scene_.world, choice, plan_, bounces_, task, log);
    Answers result = shade(lit, task);
    require_success(result.report, ReferenceMethod::name, "shade");
    return result;
  }

  const LoadedScene& scene_;
  ReferenceQuestion question_;
  std::optional<int> bounces_;
  PlanOptions plan_;
  WorkOptions common_;
  MeasuringPoints points_;
};

void keep(ReferenceValues& values, const Answers& answers) {
  values.direct.replicas.push_back(answers.direct);
  values.indirect.replicas.push_back(answers.indirect);
}

/// Of the pixels, where there are so many paths for each value at the surface.
std::uint64_t image_samples(const ReferenceGoal& goal, const ReferenceQuestion& question, std::uint64_t samples) {
  return question.camera ? whole_samples(std::min(samples, goal.image_samples_per_replica.value_or(samples)), question) : 0;
}

double error_of(const ReferenceGoal& goal, const Scene& scene, const Reference& reference) {
  return aimed_error(goal, facts_of(scene, reference));
}

bool reached(const ReferenceGoal& goal, const Scene& scene, const Reference& reference) {
  if (reference.samples_per_replica >= goal.samples_per_replica &&
      reference.image_samples_per_replica >= image_samples(goal, reference.question, goal.samples_per_replica))
    return true;
  if (!goal.target_error || reference.samples_per_replica == 0) return false;
  return error_of(goal, scene, reference) <= *goal.target_error;
}

/// After the next round: twice as many, or fewer where a target asks for fewer, as errors go with the root of the number.
std::uint64_t next_samples(const ReferenceGoal& goal, const Scene& scene, const Reference& reference) {
  const std::uint64_t before = reference.samples_per_replica;
  const std::uint64_t most = std::min(std::max(before, goal.samples_per_replica), std::max(first_round, 2 * before));
  if (!goal.target_error || before == 0) return most;
  constexpr double reserve = 1.02;  // the error is itself an estimate
  const double needed =
      static_cast<double>(before) * std::pow(error_of(goal, scene, reference) / *goal.target_error, 2.0) * reserve;
  return needed < static_cast<double>(most) ? std::max(before + 1, static_cast<std::uint64_t>(needed)) : most;
}

std::vector<std::vector<Rgb>> every(const std::vector<std::vector<Rgb>>& replicas, std::size_t first, std::size_t step) {
  std::vector<std::vector<Rgb>> chosen;
  for (std::size_t r = first; r < replicas.size(); r += step) chosen.push_back(replicas[r]);
  return chosen;
}

/// InputError for shards that calls of different --replicas or --samples made.
void check_shards(const std::vector<Reference>& shards) {
  std::size_t replicas = 0;
  for (const Reference& shard : shards) replicas += shard.surface.direct.count();
  for (std::size_t i = 0; i < shards.size(); ++i) {
    const std::size_t count = shards[i].surface.direct.count(), wanted = (replicas + shards.size() - 1 - i) / shards.size();
    const std::uint64_t samples = shards[i].samples_per_replica, wanted_samples = shards.front().samples_per_replica;
    if (count != wanted || samples != wanted_samples)
      throw InputError(fmt::format("shard {} of {}", i, shards.size()),
                       fmt::format("has {} replicates of {} samples, and {} of {} would fit the other shards", count, samples,
                                   wanted, wanted_samples),
                       "make every shard with the same --replicas and --samples");
  }
}

/// Replica r of the whole stands in shard r mod n at place r / n.
Replicas interleave(const std::vector<const Replicas*>& shards) {
  std::size_t count = 0;
  for (const Replicas* shard : shards) count += shard->count();
  Replicas whole;
  for (std::size_t r = 0; r < count; ++r) whole.replicas.push_back(shards[r % shards.size()]->replicas.at(r / shards.size()));
  return whole;
}

}  // namespace

double aimed_error(const ReferenceGoal& goal, const ReferenceFacts& facts) {
  return goal.image_samples_per_replica ? facts.surface_error.value_or(0.0) : facts.relative_standard_error();
}

std::uint64_t whole_samples(std::uint64_t samples_per_replica, const ReferenceQuestion& question) {
  const auto unit = static_cast<std::uint64_t>(question.camera ? question.pixel_samples : 1);
  return (samples_per_replica + unit - 1) / unit * unit;
}

void extend_reference(const LoadedScene& scene, const MeasuringOptions& measuring, const ReplicaSet& set,
                      const ReferenceGoal& goal, const WorkOptions& common, Reference& reference,
                      const std::function<void(const Reference&)>& after_round) {
  const ReferenceQuestion& question = reference.question;
  const ReplicaMaker maker(scene, question, measuring, common);
  const auto own = static_cast<std::size_t>(set.own());
  const std::shared_ptr<Progress> progress = common.progress_of("reference of " + scene.scene().name);
  const ReferenceGoal whole_goal{whole_samples(goal.samples_per_replica, question), goal.image_samples_per_replica,
                                 goal.target_error};
  const std::uint64_t begun_with = reference.samples_per_replica;
  while (!reached(whole_goal, scene.scene(), reference)) {
    const auto start = std::chrono::steady_clock::now();
    const std::uint64_t before = reference.samples_per_replica;
    const std::uint64_t after = whole_samples(next_samples(whole_goal, scene.scene(), reference), question);
    const ReplicaMaker::Span surface{before, after},
        image{reference.image_samples_per_replica,
              std::max(reference.image_samples_per_replica, image_samples(whole_goal, question, after))};
    Reference more{question, surface.count(), image.count(), 0.0, fingerprint_of(maker.points().surface), {}, {}};
    for (std::size_t i = 0; i < own; ++i) {
      const double in_round = static_cast<double>(i) / static_cast<double>(own);
      progress->update(fmt::format("{} samples", after),
                       (static_cast<double>(before - begun_with) + in_round * static_cast<double>(after - before)) /
                           static_cast<double>(std::max(whole_goal.samples_per_replica, after) - begun_with + 1));
      const int replica = set.first + set.shard + static_cast<int>(i) * set.of;
      if (surface.count() > 0) keep(more.surface, maker.make_surface(replica, surface));
      if (image.count() > 0) keep(more.image, maker.make_image(replica, image));
      stop_if_cancelled();
    }
    more.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (before == 0) reference = std::move(more);
    else merge(reference, more);
    after_round(reference);
  }
}

Reference shard_of(const Reference& whole, int shard, int of) {
  Reference part = whole;
  for (Replicas* replicas : {&part.surface.direct, &part.surface.indirect, &part.image.direct, &part.image.indirect})
    replicas->replicas = every(replicas->replicas, static_cast<std::size_t>(shard), static_cast<std::size_t>(of));
  part.seconds = whole.seconds / of;
  return part;
}

Reference merge_shards(const std::vector<Reference>& shards) {
  GIBENCH_CHECK(!shards.empty(), "a whole has parts");
  check_shards(shards);
  Reference whole = shards.front();
  whole.seconds = 0.0;
  std::vector<const Replicas*> surface_direct, surface_indirect, image_direct, image_indirect;
  for (const Reference& shard : shards) {
    whole.seconds += shard.seconds;
    surface_direct.push_back(&shard.surface.direct);
    surface_indirect.push_back(&shard.surface.indirect);
    image_direct.push_back(&shard.image.direct);
    image_indirect.push_back(&shard.image.indirect);
  }
  whole.surface = {interleave(surface_direct), interleave(surface_indirect)};
  whole.image = {interleave(image_direct), interleave(image_indirect)};
  return whole;
}

}  // namespace gibench
