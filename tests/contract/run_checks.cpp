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

/// A stage of a run, everything before it done.
struct Stage {
  const char* name;
  std::function<StageReport(Task&)> work;
};

/// Cancelled twice and then let run: what it takes is known when it is done, and a stage that was stopped may come again.
void verify_stage_stops(const Run& run, const Stage& stage) {
  Stop early, amid;
  early.flag->store(true);
  Task stopped(early.settings({})), midway(amid.settings({})), whole = run.task();
  early.task = &stopped;
  amid.task = &midway;
  const StageReport none = stage.work(stopped), cut = stage.work(midway), full = stage.work(whole);
  require_success(full, stage.name);
  const std::uint64_t full_rays = rays_of(full.counters);
  require_soon(none, 0, full_rays, fmt::format("{}, cancelled before it began,", stage.name));
  if (full.history.empty()) return;  // it tells of no progress, from which it could be cancelled
  require_soon(cut, amid.rays_before, full_rays, fmt::format("{}, cancelled at its first sign of progress,", stage.name));
}

/// A method that was stopped can be asked again, and answers as if nothing had been.
void verify_stopping_leaves_no_trace(Run& stopped, const Answer& fresh, Quantity quantity,
                                     const std::vector<SurfaceSample>& samples) {
  Stop early;
  early.flag->store(true);
  Task task(early.settings({}));
  early.task = &task;
  stopped.prepare(task);
  require_same_bits(fresh, stopped.prepare().light().shade(quantity, samples),
                    "a fresh run against one that follows a cancelled one");
}

}  // namespace

void verify_same_seed_same_bits(const MethodEntry& entry) {
  const World world(plain_box());
  const auto samples = samples_of(world);
  const std::vector<Quantity> quantities = light_quantities(entry);
  const std::vector<Answer> alone = fresh_answers(entry, world, quantities, samples, {.threads = 1});
  for (const char* what : {"one thread against two", "one thread against two again"}) {
    const std::vector<Answer> two = fresh_answers(entry, world, quantities, samples, {.threads = 2});
    for (std::size_t q = 0; q < quantities.size(); ++q) require_same_bits(alone[q], two[q], what);
  }
}

void verify_cancelling_stops_soon(const MethodEntry& entry) {
  const World world(plain_box());
  const auto samples = samples_of(world);
  const Quantity quantity = plainest_quantity(entry);
  Run run(entry, world);
  const Lighting lighting = Lighting::of(world.scene());
  verify_stage_stops(run, {"prepare", [&](Task& task) { return run.prepare(task); }});
  verify_stage_stops(run, {"light", [&](Task& task) { return run.light(lighting, task); }});
  verify_stage_stops(run, {"shade", [&](Task& task) {
                             Answer answer;
                             return run.shade(quantity, samples, answer, task);
                           }});
  verify_stopping_leaves_no_trace(run, fresh_answer(entry, world, quantity, samples), quantity, samples);
}

}  // namespace gibench::contract
