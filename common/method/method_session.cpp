#include "common/method/method_session.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "common/method/answer_checks.h"
#include "common/method/answer_completion.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

/// Runs one stage between two clock readings and two readings of the run's counters.
StageReport timed_stage(Task& task, const std::function<void(StageReport&)>& work) {
  StageReport report;
  const Counters before = task.counters();
  const std::size_t history_before = task.history().size();
  const auto start = std::chrono::steady_clock::now();
  work(report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.counters = task.counters().since(before);
  report.history.assign(task.history().begin() + static_cast<std::ptrdiff_t>(history_before), task.history().end());
  if (task.cancelled()) report.termination = Termination::cancelled;
  return report;
}

/// The lights that the plan leaves: none from outside a sealed scene, and no environment that the user does not allow.
Lighting lights_under(const EffectPlan& plan, const Lighting& lighting) {
  Lighting used = lighting;
  std::erase_if(used.lights, [&](const Light& light) {
    const LightKind& kind = kind_of(light);
    return (plan.sealed && kind.at_infinity) || (kind.background && plan.forbids(Effect::environment));
  });
  return used;
}

bool asks_for_variance(const ShadeAnswer& answer) {
  return !answer.direct_variance.empty() || !answer.indirect_variance.empty() || !answer.total_variance.empty();
}

}  // namespace

MethodSession::MethodSession(std::unique_ptr<TransportMethod> method) : method_(std::move(method)) {
  GIBENCH_CHECK(method_ != nullptr, "a session drives a method");
}

bool MethodSession::answers(Quantity quantity) const {
  const Capabilities can = capabilities();
  return can.quantities.contains(quantity) ||
         (follows_from_irradiance(quantity) && can.quantities.contains(Quantity::irradiance));
}

bool MethodSession::knows_variance(Quantity quantity) const {
  const Capabilities can = capabilities();
  return can.variance && can.quantities.contains(quantity);
}

/// A method that leaves direct light to the shared evaluator, and is to compute no other. Openness is not of the plan.
bool MethodSession::is_asked_for_nothing(const EffectPlan& plan) const {
  const Capabilities can = capabilities();
  return plan.skips_indirect() && !can.direct && !can.quantities.contains(Quantity::accessibility);
}

StageReport MethodSession::prepare(const World& world, const EffectPlan& plan, Task& task) {
  state_ = State::made;
  world_ = &world;
  plan_ = plan;
  direct_light_.reset();
  StageReport report = timed_stage(task, [&](StageReport& r) { run_prepare(task, r); });
  state_ = succeeded(report.termination) ? State::prepared : State::made;
  return report;
}

void MethodSession::run_prepare(Task& task, StageReport& report) {
  idle_ = is_asked_for_nothing(plan_);
  if (idle_) report.message = "the plan calls for no indirect light: nothing to prepare";
  else method_->prepare(*world_, plan_, task, report);
}

/// The plan for the scene as it is now, within the limits of the former plan.
void MethodSession::plan_again(const Lighting& lighting) {
  const std::string light_paths = plan_.light_paths;
  plan_ = plan_effects(analyse_effects(*world_, lighting, *plan_.limits), effects_of(capabilities()));
  plan_.light_paths = light_paths;
}

void MethodSession::rebuild_direct_light(const Lighting& used) {
  GIBENCH_CHECK(used.emission.size() == world_->scene().materials.size(), "one emission for each material");
  DirectLightOptions options;
  options.tests_visibility =
      !plan_.limits || plan_.simulates(Effect::occlusion) || lights_may_be_hidden(*world_, plan_.arrangement, plan_.sealed, used);
  options.surfaces_in_sight = plan_.arrangement != Arrangement::no_mutual_sight;
  options.glossy = !plan_.forbids(Effect::glossy_final_bounce);
  direct_light_ = std::make_unique<DirectLight>(*world_, used, options);
}

StageReport MethodSession::light(const Lighting& lighting, Task& task) {
  GIBENCH_CHECK(state_ != State::made, "light() comes after a prepare() that succeeded");
  state_ = State::prepared;
  StageReport report = timed_stage(task, [&](StageReport& r) { run_light(lighting, task, r); });
  if (succeeded(report.termination)) state_ = State::lit;
  return report;
}

void MethodSession::run_light(const Lighting& lighting, Task& task, StageReport& report) {
  rebuild_direct_light(lights_under(plan_, lighting));
  if (plan_.unlit && plan_.limits && !direct_light_->dark()) {
    // The method has prepared for a plan that no longer holds.
    plan_again(lighting);
    rebuild_direct_light(lights_under(plan_, lighting));
    state_ = State::made;
    run_prepare(task, report);
    if (!succeeded(report.termination) || task.cancelled()) return;
    state_ = State::prepared;
  }
  const bool dark = direct_light_->dark() && !capabilities().quantities.contains(Quantity::accessibility);
  if (idle_ || dark) {
    report.message = dark ? "no light: nothing to transport" : "nothing to transport";
    return;
  }
  const Lighting used = lights_under(plan_, lighting);
  method_->light({used, *direct_light_}, task, report);
}

StageReport MethodSession::edit(const SceneEdit& edit, const World& after, const Lighting& lighting, Task& task) {
  GIBENCH_CHECK(state_ != State::made, "edit() comes after a prepare() that succeeded");
  state_ = State::made;
  world_ = &after;
  StageReport report = timed_stage(task, [&](StageReport& r) { run_edit(edit, lighting, task, r); });
  state_ = succeeded(report.termination) ? State::lit : State::made;
  return report;
}

void MethodSession::run_edit(const SceneEdit& edit, const Lighting& lighting, Task& task, StageReport& report) {
  if (plan_.limits) plan_again(lighting);
  const bool was_idle = idle_;
  idle_ = is_asked_for_nothing(plan_);
  const Lighting used = lights_under(plan_, lighting);
  rebuild_direct_light(used);
  if (idle_) {
    report.message = "the plan calls for no indirect light: nothing to do";
  } else if (was_idle || direct_light_->dark()) {
    method_->prepare(*world_, plan_, task, report);
    if (succeeded(report.termination) && !task.cancelled()) run_light(lighting, task, report);
  } else {
    method_->edit(edit, *world_, plan_, {used, *direct_light_}, task, report);
  }
}

StageReport MethodSession::shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const {
  GIBENCH_CHECK(state_ == State::lit, "shade() comes after a light() that succeeded");
  check_sizes(request, answer);
  GIBENCH_CHECK(answers(request.quantity), "a method is asked only for quantities that it answers");
  GIBENCH_CHECK(!asks_for_variance(answer) || knows_variance(request.quantity), "variance is asked only of methods that know it");
  fill_with_nan(answer);
  StageReport report = timed_stage(task, [&](StageReport& r) {
    const ShadeAnswer planned = request.quantity == Quantity::accessibility ? answer : without_the_skipped(answer);
    if (!planned.empty()) run_shade(request, planned, task, r);
  });
  check_written(answer, report);
  return report;
}

/// Asks the method for what it answers itself, and completes the rest.
void MethodSession::run_shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport& report) const {
  const Capabilities can = capabilities();
  const bool derived = !can.quantities.contains(request.quantity);
  const bool completed = !can.direct && request.quantity != Quantity::accessibility && !answer.direct.empty();
  ShadeAnswer own = answer;
  if (completed) own.direct = {};
  if (!own.empty()) {
    const ShadeRequest irradiance{Quantity::irradiance, request.samples, {}};
    method_->shade(derived ? irradiance : request, own, task, report);
    if (derived) derive_from_irradiance(*world_, *direct_light_, request, own);
  }
  if (completed) shade_direct(*world_, *direct_light_, request, answer.direct, task);
}

/// Zeroes what the plan skips, or all of it in the dark, and gives what is left to ask for.
ShadeAnswer MethodSession::without_the_skipped(const ShadeAnswer& answer) const {
  ShadeAnswer rest = answer;
  const auto skip = [](std::span<Rgb>& values) {
    std::fill(values.begin(), values.end(), Rgb());
    values = {};
  };
  const bool dark = direct_light_->dark();
  const bool no_direct = plan_.limits && plan_.leaves_out(Effect::direct), no_indirect = plan_.skips_indirect();
  if (dark || no_direct) skip(rest.direct), skip(rest.direct_variance);
  if (dark || no_indirect) skip(rest.indirect), skip(rest.indirect_variance);
  if (dark || (no_direct && no_indirect)) skip(rest.total_variance);
  return rest;
}

std::unique_ptr<MethodSession> make_session(const MethodEntry& entry, const Parameters& parameters) {
  return std::make_unique<MethodSession>(entry.make(parameters));
}

}  // namespace gibench
