#include "common/ray/embree/embree_scene.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <cstdint>

#include "common/core/byte_size.h"
#include "common/core/error.h"

namespace gibench {

namespace {

/// With less, Embree and TBB wait for ever for threads that cannot be started, or end the program.
constexpr std::uint64_t least_address_space = std::uint64_t{1} << 30U;  // bytes

void require_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= least_address_space) return;
  throw WorkError("this process may take " + byte_size(static_cast<double>(limit.rlim_cur)) +
                  " of address space, too little for rays: allow at least 1.07 GB (ulimit -v 1048576)");
}

}  // namespace

EmbreeScene::EmbreeScene() {
  require_address_space();
  // A thread count given to the device would bind the whole process while the device lives: the arena in build()
  // binds the building alone.
  device_ = rtcNewDevice(nullptr);
  if (device_ == nullptr) throw WorkError("Embree could not make a device");
  rtcSetDeviceErrorFunction(device_, keep_error, this);
  rtcSetDeviceMemoryMonitorFunction(device_, count_memory, this);
  scene_ = rtcNewScene(device_);
}

EmbreeScene::~EmbreeScene() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

bool EmbreeScene::count_memory(void* self, ssize_t bytes, bool) {
  static_cast<EmbreeScene*>(self)->bytes_ += bytes;
  return true;
}

/// Embree calls this from inside its own code, through which nothing may be thrown.
void EmbreeScene::keep_error(void* self, RTCError code, const char* text) {
  EmbreeScene& scene = *static_cast<EmbreeScene*>(self);
  const std::lock_guard lock(scene.error_mutex_);
  if (scene.error_.empty())
    scene.error_ = "Embree error " + std::to_string(static_cast<int>(code)) + ": " + (text != nullptr ? text : "");
}

void EmbreeScene::build(RTCGeometry geometry, int threads) {
  if (geometry != nullptr) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { rtcJoinCommitScene(scene_); });
  if (!error_.empty()) throw WorkError(error_);
}

}  // namespace gibench
