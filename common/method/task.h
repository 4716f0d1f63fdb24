/// The task that a method works on: seed, threads, cancellation, progress, and the run's counters.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "common/core/counters.h"
#include "common/core/parallel.h"
#include "common/method/stage_report.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"

namespace gibench {

/// What the caller gives to a run.
struct TaskSettings {
  std::uint64_t seed = 1;
  int threads = 0;                                        ///< 0: all cores
  std::shared_ptr<std::atomic<bool>> cancel;              ///< set it to stop the work; may be empty
  std::function<void(const ProgressPoint&)> on_progress;  ///< called from the thread that runs the stage
};

/// One run. Counters and ray counts belong to it.
class Task {
 public:
  explicit Task(TaskSettings settings = {}) : settings_(std::move(settings)) {}

  std::uint64_t seed() const { return settings_.seed; }
  int threads() const { return settings_.threads; }
  bool cancelled() const { return settings_.cancel && settings_.cancel->load(std::memory_order_relaxed); }

  /// A counted tap on the world's rays, one per chunk of a loop.
  RayStream rays(const World& world) { return RayStream(world.rays(), ray_counts_); }
  /// Counts outside parallel loops.
  void count(std::string_view name, std::uint64_t amount) { counters_.add(name, amount); }
  /// All counts so far, `closest_hit_rays` and `occlusion_rays` among them.
  Counters counters() const;

  /// Chunked loop of `common/core/parallel.h` that skips the chunks left once the run is cancelled.
  void parallel_chunks(std::size_t count, std::size_t chunk_size, const std::function<void(const ChunkRange&)>& body);

  /// Reports how far the stage is; also kept in the stage's history. Not from inside parallel loops.
  void progress(std::string_view step, double done, double residual = -1.0);

  const std::vector<ProgressPoint>& history() const { return history_; }

 private:
  TaskSettings settings_;
  Counters counters_;
  RayCounts ray_counts_;
  std::vector<ProgressPoint> history_;
};

}  // namespace gibench
