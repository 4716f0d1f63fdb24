#include "common/method/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <vector>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/effects/scene_effects.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

constexpr std::size_t shade_chunk = 64;  // samples
// Light samples, and as many hemisphere samples, that the shared evaluator spends: on one surface sample at least and
// at most, and between them so that a call with few samples is answered to a few tenths of a per cent.
constexpr std::size_t least_direct_samples = 32, most_direct_samples = 65536, direct_samples_a_call = std::size_t{1} << 19;
constexpr std::uint64_t direct_stage = 0x646972656374ULL;

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

void poison(std::span<Rgb> values) {
  for (Rgb& value : values) value = Rgb(std::numeric_limits<float>::quiet_NaN());
}

bool is_empty(const ShadeAnswer& answer) {
  return answer.direct.empty() && answer.indirect.empty() && answer.direct_variance.empty() && answer.indirect_variance.empty() &&
         answer.total_variance.empty();
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

/// Turns the report into invalid_output at the first value that was not written or is not finite.
void check_written(std::span<const Rgb> values, const char* what, StageReport& report) {
  if (!succeeded(report.termination)) return;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_finite(values[i])) {
      report.termination = Termination::invalid_output;
      report.message = fmt::format("{} of sample {} was not written or is not finite", what, i);
      return;
    }
}

}  // namespace

EffectSet effects_of(const Capabilities& can) {
  EffectSet effects = can.effects;
  if (!can.direct) effects.insert(Effect::direct);
  return effects;
}

std::string TransportMethod::do_light_paths(const EffectPlan& plan, const BounceRange& range) const {
  return light_paths_of(plan, !capabilities().direct, range);
}

/// A method that leaves direct light to the shared evaluator, and is to compute no other. Openness is not of the plan.
bool TransportMethod::has_nothing_to_do(const EffectPlan& plan) const {
  const Capabilities can = capabilities();
  return plan.skips_indirect() && !can.direct && !can.quantities.contains(Quantity::accessibility);
}

StageReport TransportMethod::prepare(const World& world, const EffectPlan& plan, Task& task) {
  world_ = &world;
  plan_ = plan;
  lit_ = false;
  direct_light_.reset();
  StageReport report = timed_stage(task, [&](StageReport& r) { run_prepare(task, r); });
  prepared_ = succeeded(report.termination);
  return report;
}

void TransportMethod::run_prepare(Task& task, StageReport& report) {
  idle_ = has_nothing_to_do(plan_);
  if (idle_) report.message = "the plan calls for no indirect light: nothing to prepare";
  else do_prepare(task, report);
}

/// What the scene calls for as it now is, within the limits of the plan it had.
void TransportMethod::plan_again(const Lighting& lighting) {
  const std::string light_paths = plan_.light_paths;
  plan_ = plan_effects(analyse_effects(*world_, lighting, *plan_.limits), effects_of(capabilities()));
  plan_.light_paths = light_paths;
}

void TransportMethod::rebuild_direct_light(const Lighting& lighting) {
  GIBENCH_CHECK(lighting.emission.size() == world_->scene().materials.size(), "one emission for each material");
  tests_visibility_ = !plan_.limits || plan_.simulates(Effect::occlusion) ||
                      lights_may_be_hidden(*world_, plan_.arrangement, plan_.sealed, lighting);
  DirectLightOptions options;
  options.tests_visibility = tests_visibility_;
  options.surfaces_in_sight = plan_.arrangement != Arrangement::no_mutual_sight;
  options.glossy = !plan_.forbids(Effect::glossy_final_bounce);
  direct_light_ = std::make_unique<DirectLight>(*world_, lighting, options);
}

StageReport TransportMethod::light(const Lighting& lighting, Task& task) {
  GIBENCH_CHECK(prepared_, "light() comes after a prepare() that succeeded");
  StageReport report = timed_stage(task, [&](StageReport& r) { run_light(lighting, task, r); });
  lit_ = succeeded(report.termination);
  return report;
}

void TransportMethod::run_light(const Lighting& lighting, Task& task, StageReport& report) {
  rebuild_direct_light(lights_under(plan_, lighting));
  if (plan_.unlit && plan_.limits && !direct_light_->dark()) {
    plan_again(lighting);
    rebuild_direct_light(lights_under(plan_, lighting));
    if (idle_) run_prepare(task, report);
    if (!succeeded(report.termination) || task.cancelled()) return;
  }
  const bool dark = direct_light_->dark() && !capabilities().quantities.contains(Quantity::accessibility);
  if (idle_ || dark) report.message = dark ? "no light: nothing to transport" : "nothing to transport";
  else do_light(lights_under(plan_, lighting), task, report);
}

StageReport TransportMethod::edit(const SceneEdit& edit, const World& after, const Lighting& lighting, Task& task) {
  GIBENCH_CHECK(prepared_, "edit() comes after a prepare() that succeeded");
  world_ = &after;
  StageReport report = timed_stage(task, [&](StageReport& r) {
    if (plan_.limits) plan_again(lighting);
    const bool was_idle = idle_;
    idle_ = has_nothing_to_do(plan_);
    const Lighting used = lights_under(plan_, lighting);
    rebuild_direct_light(used);
    if (idle_) {
      r.message = "the plan calls for no indirect light: nothing to do";
    } else if (was_idle || direct_light_->dark()) {
      do_prepare(task, r);
      if (succeeded(r.termination) && !task.cancelled()) run_light(lighting, task, r);
    } else {
      do_edit(edit, used, task, r);
    }
  });
  prepared_ = lit_ = succeeded(report.termination);
  return report;
}

void TransportMethod::do_edit(const SceneEdit&, const Lighting& lighting, Task& task, StageReport& report) {
  do_prepare(task, report);
  if (succeeded(report.termination) && !task.cancelled()) do_light(lighting, task, report);
}

StageReport TransportMethod::shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const {
  GIBENCH_CHECK(lit_, "shade() comes after a light() that succeeded");
  const std::size_t count = request.samples.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == count; };
  GIBENCH_CHECK(fits(answer.direct.size()) && fits(answer.indirect.size()), "one value for each sample");
  GIBENCH_CHECK(
      fits(answer.direct_variance.size()) && fits(answer.indirect_variance.size()) && fits(answer.total_variance.size()),
      "one variance for each sample");
  GIBENCH_CHECK(request.toward_viewer.size() == (request.quantity == Quantity::radiance ? count : 0),
                "one direction for each sample where radiance is asked for");
  const Capabilities can = capabilities();
  GIBENCH_CHECK(
      can.variance || (answer.direct_variance.empty() && answer.indirect_variance.empty() && answer.total_variance.empty()),
      "variance is asked only of methods that know it");
  for (std::span<Rgb> values :
       {answer.direct, answer.indirect, answer.direct_variance, answer.indirect_variance, answer.total_variance})
    poison(values);

  StageReport report = timed_stage(task, [&](StageReport& r) {
    const ShadeAnswer planned = request.quantity == Quantity::accessibility ? answer : without_the_skipped(answer);
    if (is_empty(planned)) return;
    if (request.quantity == Quantity::radiosity && !can.quantities.contains(Quantity::radiosity)) {
      shade_radiosity(request, planned, task, r);
      return;
    }
    GIBENCH_CHECK(can.quantities.contains(request.quantity), "a method is asked only for quantities that it answers");
    ShadeAnswer own = planned;
    if (!can.direct && request.quantity != Quantity::accessibility) own.direct = {};
    if (!is_empty(own)) do_shade(request, own, task, r);
    if (own.direct.size() != planned.direct.size()) shade_direct(request, planned.direct, task);
  });
  check_written(answer.direct, "direct light", report);
  check_written(answer.indirect, "indirect light", report);
  for (std::span<const Rgb> variance : {answer.direct_variance, answer.indirect_variance, answer.total_variance})
    check_written(variance, "the variance", report);
  return report;
}

/// Zeroes what the plan skips, or all of it in the dark, and gives what is left to ask for.
ShadeAnswer TransportMethod::without_the_skipped(const ShadeAnswer& answer) const {
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

void TransportMethod::shade_direct(const ShadeRequest& request, std::span<Rgb> direct, Task& task) const {
  const std::size_t wanted = direct_samples_a_call / std::max<std::size_t>(1, direct.size());
  const int samples = static_cast<int>(std::clamp(wanted, least_direct_samples, most_direct_samples));
  task.parallel_chunks(direct.size(), shade_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world());
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const std::uint64_t key = mix_keys(task.seed(), direct_stage, i);
      direct[i] = request.quantity == Quantity::irradiance
                      ? direct_light_->irradiance(request.samples[i], key, samples, rays)
                      : direct_light_->radiance(request.samples[i], request.toward_viewer[i], key, samples, rays);
    }
  });
}

/// Radiosity of diffuse surfaces: B = π Le + ρ E, the emission counted as direct.
void TransportMethod::shade_radiosity(const ShadeRequest& request, const ShadeAnswer& answer, Task& task,
                                      StageReport& report) const {
  GIBENCH_CHECK(answer.direct_variance.empty() && answer.indirect_variance.empty() && answer.total_variance.empty(),
                "a derived radiosity has no variance");
  const ShadeRequest irradiance{Quantity::irradiance, request.samples, {}};
  const bool own_direct = capabilities().direct;
  const ShadeAnswer own{own_direct ? answer.direct : std::span<Rgb>{}, answer.indirect, {}, {}, {}};
  if (!is_empty(own)) do_shade(irradiance, own, task, report);
  if (!own_direct && !answer.direct.empty()) shade_direct(irradiance, answer.direct, task);
  for (std::size_t i = 0; i < request.samples.size(); ++i) {
    const SurfaceSample& sample = request.samples[i];
    const Rgb albedo = sample.lit_side ? world().scene().material_of_object(sample.object).diffuse : Rgb();
    if (!answer.direct.empty()) answer.direct[i] = direct_light_->emission(sample) * pi + albedo * answer.direct[i];
    if (!answer.indirect.empty()) answer.indirect[i] *= albedo;
  }
}

}  // namespace gibench
