#include "common/geometry/surface_sampling.h"

#include <algorithm>
#include <cmath>

#include "common/core/random.h"

namespace gibench {

namespace {

constexpr std::uint64_t stage_key = 0x73616d706c6573ULL;

struct Side {
  std::uint32_t triangle;
  bool front;
};

}  // namespace

std::vector<SurfaceSample> area_uniform_samples(const World& world, std::size_t count, std::uint64_t seed) {
  const Scene& scene = world.scene();
  std::vector<Side> sides;
  std::vector<double> area_up_to;  // cumulative area, m²
  double total = 0.0;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    if (!(world.area(t) > 0.0F)) continue;
    const bool two_sided = scene.objects[scene.triangle_object[t]].two_sided;
    for (int side = 0; side < (two_sided ? 2 : 1); ++side) {
      sides.push_back({t, side == 0});
      area_up_to.push_back(total += static_cast<double>(world.area(t)));
    }
  }
  std::vector<SurfaceSample> samples;
  if (sides.empty()) return samples;
  samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(seed, stage_key, i);
    const double target = total * ((static_cast<double>(i) + random.next_double()) / static_cast<double>(count));
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, target);
    const Side& side = sides[static_cast<std::size_t>(found - area_up_to.begin())];
    const float root = std::sqrt(random.next_float());
    const float second = random.next_float();
    const Vec3 normal = world.normal(side.triangle);
    samples.push_back(world.sample_at(side.triangle, {root * (1.0F - second), root * second}, side.front ? normal : -normal));
  }
  return samples;
}

}  // namespace gibench
