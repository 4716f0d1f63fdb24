/// A scene that the method has solved, and means of its answers, for tests of whole modes.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "methods/antiradiance/antiradiance.h"

namespace gibench {

/// (name, text) of parameters.
using Setting = std::vector<std::pair<std::string, std::string>>;

/// A scene with its light solved for by the method, and the reports of its stages.
class Solved {
 public:
  Solved(Scene scene, Setting settings) : world_(std::move(scene)) {
    const MethodEntry entry = antiradiance_entry();
    method_ = make_session(entry, Parameters(entry.schema, settings));
    const EffectPlan plan = plan_effects(analyse_effects(world_), method_->capabilities().effects);
    prepared = method_->prepare(world_, plan, task_);
    if (succeeded(prepared.termination)) lit = method_->light(Lighting::of(world_.scene()), task_);
  }
  std::vector<Rgb> irradiance(const std::vector<SurfaceSample>& samples) {
    std::vector<Rgb> indirect(samples.size());
    shaded = method_->shade({Quantity::irradiance, samples, {}}, {{}, indirect, {}, {}, {}}, task_);
    EXPECT_TRUE(succeeded(shaded.termination)) << shaded.message;
    return indirect;
  }
  std::vector<SurfaceSample> samples(std::size_t count = 2000) const { return area_uniform_samples(world_, count, 5); }
  std::vector<SurfaceSample> samples_of_object(std::uint32_t object, std::size_t count) const {
    std::vector<SurfaceSample> found;
    for (const SurfaceSample& sample : samples(count))
      if (sample.object == object) found.push_back(sample);
    return found;
  }
  const World& world() const { return world_; }
  StageReport prepared, lit, shaded;

 private:
  World world_;
  Task task_;
  std::unique_ptr<MethodSession> method_;
};

inline double mean(const std::vector<Rgb>& values) {
  double sum = 0.0;
  for (const Rgb& value : values) sum += static_cast<double>(value.g);
  return sum / static_cast<double>(values.size());
}

/// Root of the mean squared difference, over the mean of the second.
inline double difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(static_cast<double>(a[i].g - b[i].g), 2.0);
  return std::sqrt(sum / static_cast<double>(a.size())) / mean(b);
}

}  // namespace gibench
