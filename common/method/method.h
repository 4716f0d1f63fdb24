/// The interface of every transport method. The public calls check, time, count and poison; the private ones
/// do the work.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/core/rgb.h"
#include "common/effects/effect_plan.h"
#include "common/effects/plan_paths.h"
#include "common/lighting/direct_light.h"
#include "common/method/parameters.h"
#include "common/method/quantity.h"
#include "common/method/stage_report.h"
#include "common/method/task.h"
#include "common/ray/world.h"

namespace gibench {

/// What a method can do, as flags: nobody asks for its name.
struct Capabilities {
  EffectSet effects;
  std::set<Quantity> quantities;  ///< what do_shade() answers; radiosity is derived from irradiance where absent
  bool direct = true;             ///< computes direct light itself; else the shared evaluator completes it
  bool indirect = true;
  bool variance = false;         ///< knows the variance of its answers
  bool relights = false;         ///< light() again without prepare() costs less than both
  bool any_light_paths = false;  ///< obeys EffectPlan::light_paths
};

/// The effects of a method's answers: its own, and direct light where the shared evaluator completes it.
EffectSet effects_of(const Capabilities& can);

/// What is asked: one quantity at each sample.
struct ShadeRequest {
  Quantity quantity = Quantity::radiance;
  std::span<const SurfaceSample> samples;
  std::span<const Vec3> toward_viewer;  ///< unit directions for radiance, one a sample; empty otherwise
};

/// Where the answer goes: each span is empty (not asked for) or as long as the samples. accessibility is
/// written to `direct`, three equal channels. Variances are those of the value itself, per channel; only from
/// methods whose capabilities say so.
struct ShadeAnswer {
  std::span<Rgb> direct, indirect;
  std::span<Rgb> direct_variance, indirect_variance, total_variance;
};

class TransportMethod {
 public:
  virtual ~TransportMethod() = default;

  virtual Capabilities capabilities() const noexcept = 0;
  /// Why this method cannot work on this scene; asked before time is spent.
  virtual std::optional<std::string> refusal(const Scene&) const { return std::nullopt; }
  /// The light paths that shade() answers under a plan, between a light and the surface asked about, as an expression.
  std::string light_paths(const EffectPlan& plan, const BounceRange& range = {}) const { return do_light_paths(plan, range); }
  /// Bytes that the method holds between its stages, without the scene and the ray backend.
  virtual std::size_t bytes() const { return 0; }

  // What a plan makes needless is not asked of the method: without lights, and without indirect light for a method that
  // computes no other, do_prepare(), do_light() and do_shade() are not called and the answer is zero. Lights that the
  // plan rules out are not passed on. Where other lights or an edit call for more than the plan, it is made anew.

  /// Geometry and materials only. The world must outlive the method's use of it.
  StageReport prepare(const World& world, const EffectPlan& plan, Task& task);
  /// The lights; again without prepare() when they change.
  StageReport light(const Lighting& lighting, Task& task);
  /// After one edit of the scene, with its lights: by default prepare and light again.
  StageReport edit(const SceneEdit& edit, const World& after, const Lighting& lighting, Task& task);
  /// Answers at surface samples, every value written and finite, or the report says so.
  StageReport shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const;

 protected:
  const World& world() const { return *world_; }
  const EffectPlan& plan() const { return plan_; }
  const DirectLight& direct_light() const { return *direct_light_; }
  /// From do_light() on: whether something may lie between a light and a lit side that faces it. False: no occlusion ray
  /// is needed towards a light.
  bool tests_visibility() const { return tests_visibility_; }

 private:
  /// Each fills report.termination and report.message; time, counters and history are the caller's.
  virtual void do_prepare(Task& task, StageReport& report) = 0;
  virtual void do_light(const Lighting& lighting, Task& task, StageReport& report) = 0;
  virtual void do_edit(const SceneEdit& edit, const Lighting& lighting, Task& task, StageReport& report);
  virtual void do_shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport& report) const = 0;

  /// By default that of the plan; where the method leaves direct light to the shared evaluator, that part with every lobe.
  virtual std::string do_light_paths(const EffectPlan& plan, const BounceRange& range) const;

  bool has_nothing_to_do(const EffectPlan& plan) const;
  void plan_again(const Lighting& lighting);
  void run_prepare(Task& task, StageReport& report);
  void run_light(const Lighting& lighting, Task& task, StageReport& report);
  void rebuild_direct_light(const Lighting& lighting);
  ShadeAnswer without_the_skipped(const ShadeAnswer& answer) const;
  void shade_direct(const ShadeRequest& request, std::span<Rgb> direct, Task& task) const;
  void shade_radiosity(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport& report) const;

  const World* world_ = nullptr;
  EffectPlan plan_;
  std::unique_ptr<DirectLight> direct_light_;
  bool prepared_ = false, lit_ = false;
  bool idle_ = false;  ///< do_prepare() was not called, as the plan leaves the method nothing to do
  bool tests_visibility_ = true;
};

/// A method as the program lists it and makes it.
struct MethodEntry {
  std::string name;
  std::string summary;      ///< one line
  std::string source;       ///< the paper
  std::string light_paths;  ///< what it computes at most, as an OSL light-path expression; under a plan: light_paths()
  ParameterSchema schema;
  std::unique_ptr<TransportMethod> (*make)(const Parameters&);
  /// Settings for a rough answer in little time, a second or less in a simple room: what the contract's tests run on.
  std::vector<std::pair<std::string, std::string>> quick = {};
  /// The parameter, if any, whose choices are techniques of their own: each has to keep the contract.
  std::string technique_parameter = {};
};

}  // namespace gibench
