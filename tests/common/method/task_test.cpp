#include "common/method/task.h"

#include <gtest/gtest.h>

#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

TEST(Task, CountsItsOwnRaysAndNoOthers) {
  const World world(made::box_scene(), 1);
  Task first, second;
  const Ray ray{{0.5F, 0.5F, 0.5F}, 0.0F, {0.0F, 0.0F, 1.0F}};
  first.parallel_chunks(10, 3, [&](const ChunkRange& range) {
    RayStream rays = first.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) rays.closest_hit(ray);
  });
  second.rays(world).occluded(ray);
  second.count("links", 4);
  EXPECT_EQ(first.counters()["closest_hit_rays"], 10U);
  EXPECT_EQ(first.counters().values().size(), 2U) << "both kinds of rays and nothing else";
  EXPECT_EQ(first.counters().values().at("occlusion_rays"), 0U) << "none is measured too";
  EXPECT_EQ(second.counters()["occlusion_rays"], 1U);
  EXPECT_EQ(second.counters()["links"], 4U);
}

TEST(Task, CancellingSkipsTheChunksLeft) {
  TaskSettings settings;
  settings.threads = 1;
  settings.cancel = std::make_shared<std::atomic<bool>>(false);
  Task task(settings);
  int chunks = 0;
  task.parallel_chunks(100, 10, [&](const ChunkRange&) {
    if (++chunks == 3) *settings.cancel = true;
  });
  EXPECT_TRUE(task.cancelled());
  EXPECT_EQ(chunks, 3);
}

TEST(Task, ProgressIsToldAndKept) {
  TaskSettings settings;
  std::vector<double> reported;
  settings.on_progress = [&](const ProgressPoint& point) { reported.push_back(point.done); };
  Task task(settings);
  task.progress("bounces", 0.5, 0.1);
  task.progress("bounces", 1.0);
  EXPECT_EQ(reported, (std::vector<double>{0.5, 1.0}));
  ASSERT_EQ(task.history().size(), 2U);
  EXPECT_EQ(task.history()[0].residual, 0.1);
  EXPECT_LT(task.history()[1].residual, 0.0) << "none given";
}

TEST(Termination, SucceededMeansThatTheAnswerMayBeUsed) {
  for (const Termination good : {Termination::done, Termination::converged, Termination::bound_reached})
    EXPECT_TRUE(succeeded(good)) << to_string(good);
  for (const Termination bad :
       {Termination::not_converged, Termination::out_of_budget, Termination::cancelled, Termination::invalid_output})
    EXPECT_FALSE(succeeded(bad)) << to_string(bad);
}

}  // namespace
}  // namespace gibench
