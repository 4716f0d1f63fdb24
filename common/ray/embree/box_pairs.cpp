#include "common/ray/embree/box_pairs.h"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "common/ray/embree/embree_scene.h"

namespace gibench {

namespace {

void write_bounds(const RTCBoundsFunctionArguments* arguments) {
  const Box& box = static_cast<const Box*>(arguments->geometryUserPtr)[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.low.x, bounds.lower_y = box.low.y, bounds.lower_z = box.low.z;
  bounds.upper_x = box.high.x, bounds.upper_y = box.high.y, bounds.upper_z = box.high.z;
}

struct Search {
  const std::function<bool(std::uint32_t, std::uint32_t)>& keep;
  std::vector<IndexPair> found;
  std::mutex mutex;

  /// The same pair comes from both sides, and a box meets itself.
  static void meet(void* self, RTCCollision* collisions, unsigned count) {
    Search& search = *static_cast<Search*>(self);
    for (unsigned i = 0; i < count; ++i) {
      const std::uint32_t a = std::min(collisions[i].primID0, collisions[i].primID1);
      const std::uint32_t b = std::max(collisions[i].primID0, collisions[i].primID1);
      if (a == b || !search.keep(a, b)) continue;
      const std::lock_guard lock(search.mutex);  // few pairs are kept
      search.found.push_back({a, b});
    }
  }
};

}  // namespace

std::vector<IndexPair> overlapping_boxes(std::span<const Box> boxes, int threads,
                                         const std::function<bool(std::uint32_t, std::uint32_t)>& keep) {
  if (boxes.empty()) return {};
  EmbreeScene embree;
  RTCGeometry geometry = rtcNewGeometry(embree.device(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, const_cast<Box*>(boxes.data()));  // only read
  rtcSetGeometryBoundsFunction(geometry, write_bounds, nullptr);
  embree.build(geometry, threads);
  Search search{keep, {}, {}};
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { rtcCollide(embree.scene(), embree.scene(), Search::meet, &search); });
  std::sort(search.found.begin(), search.found.end());
  search.found.erase(std::unique(search.found.begin(), search.found.end()), search.found.end());
  return std::move(search.found);
}

}  // namespace gibench
