// Paths of many values in one batch.
#include <gtest/gtest.h>

#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/pathtracer/pathtracer.h"
#include "tests/support/counting_rays.h"

namespace gibench {
namespace {

TEST(PathBatch, PathsOfDifferentValuesTravelTogether) {
  // One path for each of 512 values: every reflection is a call for closest hits and one for shadow rays.
  const test::CountedWorld counted(made::box_scene());
  const MethodEntry entry = pathtracer_entry();
  const auto method = make_session(entry, Parameters(entry.schema, {{"samples", "1"}}));
  Task task;
  ASSERT_TRUE(succeeded(method->prepare(counted.world, EffectPlan(), task).termination));
  ASSERT_TRUE(succeeded(method->light(Lighting::of(counted.world.scene()), task).termination));
  const auto samples = area_uniform_samples(counted.world, 512, 7);
  std::vector<Rgb> direct(512), indirect(512);
  const std::uint64_t calls_before = counted.calls;
  ASSERT_TRUE(succeeded(method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task).termination));
  const std::uint64_t rays = task.counters()["closest_hit_rays"] + task.counters()["occlusion_rays"];
  EXPECT_GT(rays, 512U);
  EXPECT_GT(rays / (counted.calls - calls_before), 32U) << "four full packets of eight";
}

}  // namespace
}  // namespace gibench
