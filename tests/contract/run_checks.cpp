/// Checks of a run: the same bits from the same seed, and an end when it is cancelled.
#include <fmt/format.h>

#include <atomic>
#include <functional>
#include <memory>

#include "tests/contract/compare.h"
#include "tests/contract/contract.h"
#include "tests/contract/run.h"
#include "tests/contract/scenes.h"

namespace gibench::contract {

namespace {

std::uint64_t rays_of(const Counters& counters) { return counters["closest_hit_rays"] + counters["occlusion_rays"]; }

enum class Stage { prepare, light, shade };
constexpr Stage stages[] = {Stage::prepare, Stage::light, Stage::shade};

const char* to_string(Stage stage) { return stage == Stage::prepare ? "prepare" : stage == Stage::light ? "light" : "shade"; }

/// A method at the start of a stage, everything before it done.
class AtStage {
 public:
  AtStage(const MethodEntry& entry, const World& world, Stage stage)
      : run_(entry, world), samples_(samples_of(world)), quantity_(plainest_quantity(entry)), stage_(stage) {
    if (stage != Stage::prepare) run_.prepare();
    if (stage == Stage::shade) run_.light();
  }

  StageReport work(Task& task) {
    if (stage_ == Stage::prepare) return run_.prepare(task);
    if (stage_ == Stage::light) return run_.light(Lighting::of(run_.world().scene()), task);
    Answer answer;
    return run_.shade(quantity_, samples_, answer, task);
  }
  Run& run() { return run_; }
  const std::vector<SurfaceSample>& samples() const { return samples_; }

 private:
  Run run_;
  std::vector<SurfaceSample> samples_;
  Quantity quantity_;
  Stage stage_;
};

struct Stop {
  std::shared_ptr<std::atomic<bool>> flag = std::make_shared<std::atomic<bool>>(false);
  std::uint64_t rays_before = 0;  ///< traced when the flag was set
  const Task* task = nullptr;

  TaskSettings settings(const RunOptions& options) {
    return {options.seed, options.threads, flag, [this](const ProgressPoint&) {
              if (!flag->exchange(true)) rays_before = rays_of(task->counters());
            }};
  }
};

void require_soon(const StageReport& report, std::uint64_t rays_before, std::uint64_t full_rays, const std::string& what) {
  if (report.termination != Termination::cancelled)
    throw Violation(fmt::format("{} ended as '{}'", what, gibench::to_string(report.termination)));
  const std::uint64_t late = rays_of(report.counters) - rays_before;
  if (static_cast<double>(late) > late_share * static_cast<double>(full_rays))
    throw Violation(fmt::format("{} traced {} more rays of {} that a full run takes", what, late, full_rays));
}

void verify_stage_stops(const MethodEntry& entry, const World& world, Stage stage) {
  AtStage full(entry, world, stage), before(entry, world, stage), during(entry, world, stage);
  Task whole = full.run().task();
  const StageReport report = full.work(whole);
  require_success(report, to_string(stage));
  const std::uint64_t full_rays = rays_of(report.counters);

  Stop early;
  early.flag->store(true);
  Task stopped(early.settings({}));
  early.task = &stopped;
  require_soon(before.work(stopped), 0, full_rays, fmt::format("{}, cancelled before it began,", to_string(stage)));

  if (report.history.empty()) return;  // it tells of no progress, from which it could be cancelled
  Stop amid;
  Task midway(amid.settings({}));
  amid.task = &midway;
  const StageReport cut = during.work(midway);
  require_soon(cut, amid.rays_before, full_rays, fmt::format("{}, cancelled at its first sign of progress,", to_string(stage)));
}

/// A method that was stopped can be asked again, and answers as if nothing had been.
void verify_stopping_leaves_no_trace(const MethodEntry& entry, const World& world) {
  const auto samples = samples_of(world);
  const Quantity quantity = plainest_quantity(entry);
  Run stopped(entry, world), fresh(entry, world);
  Stop early;
  early.flag->store(true);
  Task task(early.settings({}));
  early.task = &task;
  stopped.prepare().light().prepare(task);
  require_same_bits(fresh.prepare().light().shade(quantity, samples), stopped.prepare().light().shade(quantity, samples),
                    "a fresh run against one that follows a cancelled one");
}

}  // namespace

void verify_same_seed_same_bits(const MethodEntry& entry) {
  const World world(plain_box());
  const auto samples = samples_of(world);
  for (const Quantity quantity : light_quantities(entry)) {
    const Answer alone = fresh_answer(entry, world, quantity, samples, {.threads = 1});
    require_same_bits(alone, fresh_answer(entry, world, quantity, samples, {.threads = 2}), "one thread against two");
    require_same_bits(alone, fresh_answer(entry, world, quantity, samples, {.threads = 2}), "one thread against two again");
  }
}

void verify_cancelling_stops_soon(const MethodEntry& entry) {
  const World world(plain_box());
  for (const Stage stage : stages) verify_stage_stops(entry, world, stage);
  verify_stopping_leaves_no_trace(entry, world);
}

}  // namespace gibench::contract
