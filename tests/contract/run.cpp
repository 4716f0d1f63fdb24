#include "tests/contract/run.h"

#include <fmt/format.h>

#include "common/effects/scene_effects.h"

namespace gibench::contract {

void require_success(const StageReport& report, const std::string& stage) {
  if (!succeeded(report.termination))
    throw Violation(fmt::format("{} ended as '{}': {}", stage, gibench::to_string(report.termination), report.message));
}

Run::Run(const MethodEntry& entry, const World& world, const RunOptions& options)
    : world_(&world),
      options_(options),
      method_(make_session(entry, Parameters(entry.schema, entry.quick))),
      plan_(plan_effects(analyse_effects(world, PlanLimits{{}, options.bounces, 0.0, options.forced}),
                         effects_of(method_->capabilities()))) {}

StageReport Run::shade(Quantity quantity, const std::vector<SurfaceSample>& samples, Answer& answer, Task& task) const {
  // Seen along the normal: the one direction that turns with the surface.
  std::vector<Vec3> toward_viewer;
  if (quantity == Quantity::radiance)
    for (const SurfaceSample& sample : samples) toward_viewer.push_back(sample.normal);
  answer.direct.assign(samples.size(), Rgb());
  answer.indirect.assign(samples.size(), Rgb());
  return method_->shade({quantity, samples, toward_viewer}, {answer.direct, answer.indirect, {}, {}, {}}, task);
}

Run& Run::prepare() {
  Task own = task();
  require_success(prepare(own), "prepare");
  return *this;
}

Run& Run::light(const Lighting& lighting) {
  Task own = task();
  require_success(light(lighting, own), "light");
  return *this;
}

Run& Run::edit(const SceneEdit& edit, const World& after) {
  Task own = task();
  world_ = &after;
  require_success(method_->edit(edit, after, Lighting::of(after.scene()), own), "edit");
  return *this;
}

Answer Run::shade(Quantity quantity, const std::vector<SurfaceSample>& samples) const {
  Task own = task();
  Answer answer;
  require_success(shade(quantity, samples, answer, own), fmt::format("shade ({})", to_string(quantity)));
  return answer;
}

std::vector<Answer> Run::shade(const std::vector<Quantity>& quantities, const std::vector<SurfaceSample>& samples) const {
  std::vector<Answer> answers;
  for (const Quantity quantity : quantities) answers.push_back(shade(quantity, samples));
  return answers;
}

Answer fresh_answer(const MethodEntry& entry, const World& world, Quantity quantity, const std::vector<SurfaceSample>& samples,
                    const RunOptions& options) {
  return Run(entry, world, options).prepare().light().shade(quantity, samples);
}

std::vector<Answer> fresh_answers(const MethodEntry& entry, const World& world, const std::vector<Quantity>& quantities,
                                  const std::vector<SurfaceSample>& samples, const RunOptions& options) {
  return Run(entry, world, options).prepare().light().shade(quantities, samples);
}

std::vector<Quantity> light_quantities(const MethodSession& method) {
  std::vector<Quantity> answered;
  for (const Quantity quantity : {Quantity::irradiance, Quantity::radiance})
    if (method.answers(quantity)) answered.push_back(quantity);
  if (answered.empty()) throw Violation("it answers neither radiance nor irradiance");
  return answered;
}

std::vector<Quantity> light_quantities(const MethodEntry& entry) {
  return light_quantities(*make_session(entry, Parameters(entry.schema, entry.quick)));
}

Quantity plainest_quantity(const MethodEntry& entry) { return light_quantities(entry).front(); }

const char* to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::radiance: return "radiance";
    case Quantity::irradiance: return "irradiance";
    case Quantity::radiosity: return "radiosity";
    case Quantity::accessibility: return "accessibility";
  }
  return "unknown";
}

}  // namespace gibench::contract
