/// The one way to use a method: drives it through its stages and does the work that all methods share.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/effects/effect_plan.h"
#include "common/lighting/direct_light.h"
#include "common/method/capabilities.h"
#include "common/method/method_entry.h"
#include "common/method/shading.h"
#include "common/method/stage_report.h"
#include "common/method/task.h"
#include "common/ray/world.h"

namespace gibench {

/// Knows of its method nothing but the interface. It checks order and sizes, takes the time and the counts of each
/// stage, fills answers with NaN before the work and checks after it that every value was written and is finite.
///
/// What a plan makes needless is not asked of the method: without lights, and without indirect light for a method that
/// computes no other, its stages are not called and the answer is zero. Lights that the plan rules out are not passed on.
/// If other lights or an edit call for more than the plan, the plan is made anew within the same limits.
class MethodSession {
 public:
  explicit MethodSession(std::unique_ptr<TransportMethod> method);

  Capabilities capabilities() const noexcept { return method_->capabilities(); }
  std::optional<std::string> refusal(const Scene& scene) const { return method_->refusal(scene); }
  std::string light_paths(const EffectPlan& plan, const BounceRange& range = {}) const {
    return method_->light_paths(plan, range);
  }
  std::size_t bytes() const { return method_->bytes(); }

  /// Whether shade() answers a quantity: the method does so itself, or it follows from the method's irradiance. Radiosity
  /// and radiance do, as of diffuse surfaces.
  bool answers(Quantity quantity) const;
  /// Whether variances of a quantity may be asked for: the method answers it itself and knows them.
  bool knows_variance(Quantity quantity) const;

  /// Geometry and materials only. The world must outlive the session's use of it.
  StageReport prepare(const World& world, const EffectPlan& plan, Task& task);
  /// The lights; again without prepare() when they change.
  StageReport light(const Lighting& lighting, Task& task);
  /// After one edit of the scene, with its lights. The world before is no longer used.
  StageReport edit(const SceneEdit& edit, const World& after, const Lighting& lighting, Task& task);
  /// Answers at surface samples, every value written and finite, or the report says so. Direct light that the method does
  /// not compute comes from the shared evaluator.
  StageReport shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const;

 private:
  /// The stage that a method has reached: each stage builds on the one before.
  enum class State { made, prepared, lit };

  bool is_asked_for_nothing(const EffectPlan& plan) const;
  void plan_again(const Lighting& lighting);
  void run_prepare(Task& task, StageReport& report);
  void run_light(const Lighting& lighting, Task& task, StageReport& report);
  void run_edit(const SceneEdit& edit, const Lighting& lighting, Task& task, StageReport& report);
  void run_shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport& report) const;
  void rebuild_direct_light(const Lighting& used);
  ShadeAnswer without_the_skipped(const ShadeAnswer& answer) const;

  std::unique_ptr<TransportMethod> method_;
  const World* world_ = nullptr;
  EffectPlan plan_;
  std::unique_ptr<DirectLight> direct_light_;
  State state_ = State::made;
  bool idle_ = false;  ///< the method was not prepared, as the plan leaves it nothing to do
};

/// A session with a new method.
std::unique_ptr<MethodSession> make_session(const MethodEntry& entry, const Parameters& parameters);

}  // namespace gibench
