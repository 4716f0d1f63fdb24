/// Places on triangles that another surface parts: which of their corners are seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "common/geometry/surface_sampling.h"
#include "common/scene/made_scenes.h"
#include "methods/antiradiance/discretisation.h"

namespace gibench::antiradiance {
namespace {

TEST(PartedPlaces, HaveTheHeaviestCornerSeenByFewerRays) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.quad("sheet", white, {{{0.0F, 0.53F, 1.0F}, {1.0F, 0.53F, 1.0F}, {1.0F, 0.53F, 0.0F}, {0.0F, 0.53F, 0.0F}}}, true);
  const World world(builder.build("parted room"));
  Task task, for_all, for_one;
  Settings rule;
  rule.mode = Mode::radiosity;
  rule.elements = 400;
  const Discretisation parts(world, rule, task);
  int places = 0, hidden = 0;
  for (const SurfaceSample& sample : area_uniform_samples(world, 2000, 5)) {
    const Reconstruction::Place whole = Reconstruction::place(world, parts.mesh, parts.elements, sample);
    if (!whole.covered() || !parts.is_parted(whole.triangle)) continue;
    Reconstruction::Place seen = whole;
    RayStream all = for_all.rays(world), one = for_one.rays(world);
    const bool any = Reconstruction::leave_hidden_out(world, parts.mesh, parts.elements, sample, all, seen);
    const auto found = Reconstruction::heaviest_seen(world, parts.mesh, parts.elements, sample, one, whole);
    ASSERT_EQ(found.has_value(), any);
    if (!any) continue;
    const auto heaviest = std::max_element(seen.weights.begin(), seen.weights.end()) - seen.weights.begin();
    EXPECT_EQ(*found, static_cast<std::size_t>(heaviest));
    ++places;
    if (std::max_element(whole.weights.begin(), whole.weights.end()) - whole.weights.begin() != heaviest) ++hidden;
  }
  EXPECT_GT(places, 50);
  EXPECT_GT(hidden, 0);
  EXPECT_GT(for_one.counters()["occlusion_rays"] + for_one.counters()["closest_hit_rays"], 0U);
  // Of three corners the first that is looked for mostly is seen.
  EXPECT_LT(for_one.counters()["occlusion_rays"] + for_one.counters()["closest_hit_rays"],
            (for_all.counters()["occlusion_rays"] + for_all.counters()["closest_hit_rays"]) / 2);
}

}  // namespace
}  // namespace gibench::antiradiance
