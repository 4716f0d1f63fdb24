/// Embree's device and scene with its errors and its bytes; for the files of this folder alone.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

namespace gibench {

/// One scene of one geometry on a device of its own.
class EmbreeScene {
 public:
  EmbreeScene();  ///< throws WorkError
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCDevice device() const { return device_; }
  RTCScene scene() const { return scene_; }
  std::int64_t bytes() const { return bytes_.load(); }  ///< held by Embree

  /// Attaches the geometry, which the scene then owns, or none. Builds with `threads` threads (0: all cores). Throws WorkError.
  void build(RTCGeometry geometry, int threads);

 private:
  static bool count_memory(void* self, ssize_t bytes, bool);
  static void keep_error(void* self, RTCError code, const char* text);

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::atomic<std::int64_t> bytes_{0};
  std::mutex error_mutex_;
  std::string error_;  ///< the first that Embree reported
};

}  // namespace gibench
