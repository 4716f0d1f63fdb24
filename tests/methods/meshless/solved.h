/// A scene solved by the meshless method, for tests of the whole method.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/meshless/meshless.h"

namespace gibench::test {

using Setting = std::vector<std::pair<std::string, std::string>>;

/// One solved scene.
class Solved {
 public:
  explicit Solved(Scene scene, std::optional<int> bounces = std::nullopt, const Setting& settings = {}, int threads = 0)
      : world_(std::move(scene)), task_(settings_of(threads)) {
    const MethodEntry entry = meshless_entry();
    method_ = make_session(entry, Parameters(entry.schema, settings));
    EffectPlan plan;
    plan.simulated = {Effect::direct, Effect::diffuse_indirect, Effect::environment, Effect::occlusion};
    plan.max_bounces = bounces;
    prepared = method_->prepare(world_, plan, task_);
    if (succeeded(prepared.termination)) lit = method_->light(Lighting::of(world_.scene()), task_);
  }

  std::vector<Rgb> irradiance(const std::vector<SurfaceSample>& samples, Component component = Component::indirect) {
    std::vector<Rgb> direct(component == Component::indirect ? 0 : samples.size()),
        indirect(component == Component::direct ? 0 : samples.size());
    shaded = method_->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task_);
    EXPECT_TRUE(succeeded(shaded.termination)) << shaded.message;
    if (component == Component::direct) return direct;
    for (std::size_t i = 0; i < direct.size(); ++i) indirect[i] += direct[i];
    return indirect;
  }
  Rgb at(const Vec3& point, const Vec3& normal) { return irradiance({sample(point, normal)})[0]; }
  SurfaceSample sample(const Vec3& point, const Vec3& normal) const {
    const Hit hit = world_.rays().closest_hit({point + 1e-3F * normal, 0.0F, -normal});
    return world_.sample_at(hit.triangle, {hit.u, hit.v}, normal);
  }
  const World& world() const { return world_; }
  const MethodSession& method() const { return *method_; }

  StageReport prepared, lit, shaded;

 private:
  static TaskSettings settings_of(int threads) {
    TaskSettings settings;
    settings.threads = threads;
    return settings;
  }
  World world_;
  Task task_;
  std::unique_ptr<MethodSession> method_;
};

/// Rough, fast answers, for tests that are not about accuracy.
inline const Setting rough{{"levels", "4"}, {"rays", "128"}};

/// A closed room that glows with radiance 1 everywhere: every bounce is πρ times the one before, everywhere.
inline Scene furnace(const Rgb& albedo) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("glowing", albedo, Rgb(1.0F)), {0, 0, 0}, {1, 1, 1});
  return builder.build("furnace");
}

}  // namespace gibench::test
