#include "common/method/task.h"

#include <string>

namespace gibench {

Counters Task::counters() const {
  Counters all = counters_;
  all.add("closest_hit_rays", ray_counts_.closest_hit.load());  // none is measured too
  all.add("occlusion_rays", ray_counts_.occlusion.load());
  return all;
}

void Task::parallel_chunks(std::size_t count, std::size_t chunk_size, const std::function<void(const ChunkRange&)>& body) {
  gibench::parallel_chunks(threads(), count, chunk_size, [&](const ChunkRange& range) {
    if (!cancelled()) body(range);
  });
}

void Task::progress(std::string_view step, double done, double residual) {
  ProgressPoint point{std::string(step), done, residual};
  if (settings_.on_progress) settings_.on_progress(point);
  history_.push_back(std::move(point));
}

}  // namespace gibench
