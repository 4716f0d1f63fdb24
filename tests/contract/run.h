/// One method on one scene, stage by stage, for the contract's checks.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/method/method_session.h"
#include "tests/contract/contract.h"

namespace gibench::contract {

struct Answer {
  std::vector<Rgb> direct, indirect;  ///< one value per sample
};

struct RunOptions {
  std::uint64_t seed = 7;
  int threads = 2;
  std::optional<int> bounces = {};
  EffectSet forced = {};  ///< simulated though the scene does not call for it
};

/// Throws Violation where a stage does not succeed.
void require_success(const StageReport& report, const std::string& stage);

/// A method with its quick settings, made ready for a world. The world must outlive it.
class Run {
 public:
  Run(const MethodEntry& entry, const World& world, const RunOptions& options = {});

  const World& world() const { return *world_; }
  const MethodSession& method() const { return *method_; }
  const EffectPlan& plan() const { return plan_; }
  Task task() const { return Task({.seed = options_.seed, .threads = options_.threads, .cancel = {}, .on_progress = {}}); }

  StageReport prepare(Task& task) { return method_->prepare(*world_, plan_, task); }
  StageReport light(const Lighting& lighting, Task& task) { return method_->light(lighting, task); }
  StageReport shade(Quantity quantity, const std::vector<SurfaceSample>& samples, Answer& answer, Task& task) const;

  // The same with a task of their own, each of which must succeed.
  Run& prepare();
  Run& light(const Lighting& lighting);
  Run& light() { return light(Lighting::of(world_->scene())); }
  /// Under the lights of the scene after the edit, which becomes the run's world.
  Run& edit(const SceneEdit& edit, const World& after);
  Answer shade(Quantity quantity, const std::vector<SurfaceSample>& samples) const;
  std::vector<Answer> shade(const std::vector<Quantity>& quantities, const std::vector<SurfaceSample>& samples) const;

 private:
  const World* world_;
  RunOptions options_;
  std::unique_ptr<MethodSession> method_;
  EffectPlan plan_;
};

/// Prepares, lights and shades: what a program would do once.
Answer fresh_answer(const MethodEntry& entry, const World& world, Quantity quantity, const std::vector<SurfaceSample>& samples,
                    const RunOptions& options = {});
/// The same of one run that is asked several times.
std::vector<Answer> fresh_answers(const MethodEntry& entry, const World& world, const std::vector<Quantity>& quantities,
                                  const std::vector<SurfaceSample>& samples, const RunOptions& options = {});

/// Irradiance and radiance, as far as they can be asked for.
std::vector<Quantity> light_quantities(const MethodSession& method);
std::vector<Quantity> light_quantities(const MethodEntry& entry);
/// The one that does not ask for directions, where it can be asked for.
Quantity plainest_quantity(const MethodEntry& entry);
const char* to_string(Quantity quantity);

}  // namespace gibench::contract
