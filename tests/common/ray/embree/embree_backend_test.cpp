#include "common/ray/embree/embree_backend.h"

#include <gtest/gtest.h>
#ifndef GIBENCH_STD_THREADS
#include <tbb/global_control.h>
#endif

#include <memory>

#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

std::unique_ptr<const RayBackend> backend_of(const Scene& scene) {
  return make_embree_backend(scene.vertices, scene.triangles, 1);
}

TEST(EmbreeBackend, TellsTheBytesOfItsHierarchy) {
  const auto small = backend_of(made::random_triangles(100, 1.0F, 0.1F, 1));
  const auto large = backend_of(made::random_triangles(20000, 1.0F, 0.1F, 1));
  EXPECT_GT(small->bytes(), 100U * sizeof(Triangle));
  EXPECT_GT(large->bytes(), 20000U * sizeof(Triangle));
  EXPECT_GT(large->bytes(), small->bytes());
}

#ifndef GIBENCH_STD_THREADS
TEST(EmbreeBackend, ItsThreadsAreItsOwn) {
  using tbb::global_control;
  const auto allowed = [] { return global_control::active_value(global_control::max_allowed_parallelism); };
  const std::size_t before = allowed();
  const auto backend = backend_of(made::random_triangles(5000, 1.0F, 0.1F, 1));
  EXPECT_EQ(allowed(), before) << "building with one thread must not hold back the process";
}
#endif

}  // namespace
}  // namespace gibench
