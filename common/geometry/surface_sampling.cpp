#include "common/geometry/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/core/random.h"

namespace gibench {

namespace {

constexpr std::uint64_t stage_key = 0x73616d706c6573ULL;
constexpr int most_draws = 1000;  // of one sample

struct Side {
  std::uint32_t triangle;
  bool front;
};

/// The sides that light can leave, and their cumulative area.
struct Sides {
  std::vector<Side> sides;
  std::vector<double> area_up_to;  ///< m²

  explicit Sides(const World& world) {
    const Scene& scene = world.scene();
    double total = 0.0;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
      if (!(world.area(t) > 0.0F)) continue;
      const bool two_sided = scene.objects[scene.triangle_object[t]].two_sided;
      for (int side = 0; side < (two_sided ? 2 : 1); ++side) {
        sides.push_back({t, side == 0});
        area_up_to.push_back(total += static_cast<double>(world.area(t)));
      }
    }
  }

  /// The side at this fraction of the area.
  const Side& at(double fraction) const {
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, area_up_to.back() * fraction);
    return sides[static_cast<std::size_t>(found - area_up_to.begin())];
  }
};

/// A point of the side, where it is in front of all that coincides with it.
std::optional<SurfaceSample> draw(const World& world, const Side& side, RandomStream& random) {
  const float root = std::sqrt(random.next_float());
  const float second = random.next_float();
  const Vec2 place(root * (1.0F - second), root * second);
  const Vec3 normal = side.front ? world.normal(side.triangle) : -world.normal(side.triangle);
  if (!world.coincident().shows(side.triangle, place.x, place.y, -normal)) return std::nullopt;
  return world.sample_at(side.triangle, place, normal);
}

}  // namespace

std::vector<SurfaceSample> area_uniform_samples(const World& world, std::size_t count, std::uint64_t seed) {
  const Sides sides(world);
  std::vector<SurfaceSample> samples;
  if (sides.sides.empty()) return samples;
  samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(seed, stage_key, i);
    double fraction = (static_cast<double>(i) + random.next_double()) / static_cast<double>(count);
    // Most of a scene is in front: a draw that met what is behind goes anywhere else.
    std::optional<SurfaceSample> sample = draw(world, sides.at(fraction), random);
    for (int again = 0; !sample && again < most_draws; ++again) sample = draw(world, sides.at(random.next_double()), random);
    if (sample) samples.push_back(*sample);
  }
  return samples;
}

}  // namespace gibench
