#include "common/ray/embree/embree_backend.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifndef GIBENCH_STD_THREADS
#include <tbb/global_control.h>
#endif

#include <memory>
#include <string>

#include "common/core/error.h"
#include "common/ray/world.h"
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

/// 0 where a world is refused with the size in the message, in a process of its own that may take `bytes` of address space.
int refusal_under(rlim_t bytes) {
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) return 3;
  try {
    const World world(made::box_scene(), 1);
  } catch (const WorkError& error) {
    return std::string(error.what()).find("address space") != std::string::npos ? 0 : 2;
  }
  return 1;
}

TEST(EmbreeDevice, TooLittleAddressSpaceIsRefusedAtOnce) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take terabytes of address space";
#endif
  const pid_t child = fork();
  if (child == 0) _exit(refusal_under(rlim_t{300} << 20U));
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace gibench
