#include "methods/meshless/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/core/random.h"
#include "common/finite_elements/inside_geometry.h"
#include "common/finite_elements/surface_point.h"
#include "methods/meshless/edge_frame.h"

namespace gibench::meshless {

namespace {

constexpr std::uint64_t placement_stage = 0x706c616365ULL;
constexpr std::size_t ray_chunk = 1024;    // rays
constexpr double expected_density = 0.65;  // samples per squared radius of area, near saturation
constexpr std::size_t look_chunk = 16;     // points
constexpr int looks = 32;                  // rays, for the distance of what a point sees
constexpr int radius_rounds = 5;           // at most, to meet the wanted number of coarsest samples
constexpr double radius_tolerance = 0.03;  // of that number
constexpr int most_placement_rays = 4;     // of the backface test of a proposal; the next one near by is tested anew
constexpr std::uint64_t direction_stage = 0x6261636b73ULL;

/// A cosine-distributed direction in a local frame about +z.
Vec3 test_direction(int index) {
  RandomStream random(0, direction_stage, static_cast<std::uint64_t>(index));
  const float radius = std::sqrt(random.next_float()), angle = 2.0F * pi * random.next_float();
  const float x = radius * std::cos(angle), y = radius * std::sin(angle);
  return {x, y, std::sqrt(std::max(0.0F, 1.0F - x * x - y * y))};
}

std::vector<std::vector<SurfaceSide>> sides_of_groups(const World& world, const Groups& groups) {
  const std::vector<std::uint8_t> every_object(world.scene().objects.size(), 1);
  std::vector<std::vector<SurfaceSide>> sides(groups.count);
  for (const SurfaceSide& side : lit_sides(world, every_object)) sides[groups.of(side.triangle, side.front)].push_back(side);
  return sides;
}

/// The samplers of all groups, thrown level by level.
class GroupSamplers {
 public:
  GroupSamplers(const GroupSamplers&) = delete;  // its tests know where it is
  GroupSamplers& operator=(const GroupSamplers&) = delete;
  GroupSamplers(const World& world, const std::vector<std::vector<SurfaceSide>>& sides, const Settings& settings, Task& task) {
    for (std::size_t group = 0; group < sides.size(); ++group) {
      PoissonDiscOptions options;
      options.seed = mix_keys(task.seed(), placement_stage, group);
      options.threads = task.threads();
      options.failures = settings.failures;
      options.cancelled = [&task] { return task.cancelled(); };
      if (settings.backface_test)
        options.test = [this, &world, &settings, &task](std::span<const DiscPoint> points, std::span<std::uint8_t> clear) {
          clear_of_backfaces(world, points, clear, std::min(settings.backface_rays, most_placement_rays), task);
          inside_ += static_cast<std::uint64_t>(std::count(clear.begin(), clear.end(), 0));
        };
      samplers_.emplace_back(world, sides[group], options);
      area_ += samplers_.back().area();
    }
  }

  std::vector<std::vector<DiscPoint>> add_level(double radius) {
    std::vector<std::vector<DiscPoint>> level;
    for (PoissonDisc& sampler : samplers_) level.push_back(sampler.add_level(static_cast<float>(radius)));
    return level;
  }
  double area() const { return area_; }
  std::uint64_t inside() const { return inside_; }
  std::uint64_t proposals() const {
    std::uint64_t sum = 0;
    for (const PoissonDisc& sampler : samplers_) sum += sampler.proposals();
    return sum;
  }

 private:
  std::vector<PoissonDisc> samplers_;
  double area_ = 0.0;
  std::uint64_t inside_ = 0;
};

std::size_t count_of(const std::vector<std::vector<DiscPoint>>& level) {
  std::size_t count = 0;
  for (const std::vector<DiscPoint>& group : level) count += group.size();
  return count;
}

double area_of(const World& world, const std::vector<std::vector<SurfaceSide>>& sides) {
  double area = 0.0;
  for (const std::vector<SurfaceSide>& group : sides)
    for (const SurfaceSide& side : group) area += static_cast<double>(world.area(side.triangle));
  return area;
}

/// A first guess at the initial radius: as set, or by the area.
double guessed_radius(const World& world, double area, const Settings& settings) {
  if (settings.initial_radius > 0.0) return settings.initial_radius * static_cast<double>(world.diagonal());
  return std::sqrt(expected_density * area / settings.coarsest_samples);
}

/// Median over points of the harmonic mean distance of what they see, metres; infinite where most see nothing.
double typical_distance(const World& world, const std::vector<std::vector<DiscPoint>>& level, Task& task) {
  std::vector<DiscPoint> points;
  for (const std::vector<DiscPoint>& group : level) points.insert(points.end(), group.begin(), group.end());
  std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
  task.parallel_chunks(points.size(), look_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const DiscPoint& point = points[i];
      const Vec3 origin = world.ray_origin(surface_sample(world, point.side.triangle, point.position, point.normal));
      const Frame frame = frame_along_edge(world, point.side.triangle, point.normal);
      double inverse = 0.0;
      for (int ray = 0; ray < looks; ++ray)
        if (const Hit hit = stream.closest_hit({origin, 0.0F, frame.to_world(test_direction(ray))}); hit && hit.distance > 0.0F)
          inverse += 1.0 / static_cast<double>(hit.distance);
      if (inverse > 0.0) distances[i] = looks / inverse;
    }
  });
  if (distances.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// As guessed, or such that about the wanted number of coarsest samples results where light reaches; smaller where surfaces see
/// others that are near in comparison.
double initial_radius(const World& world, const Groups& groups, const std::vector<std::vector<SurfaceSide>>& all_sides,
                      const Settings& settings, Task& task) {
  std::vector<std::vector<SurfaceSide>> sides;
  for (std::size_t group = 0; group < all_sides.size(); ++group)
    if (groups.sealed[group] == 0) sides.push_back(all_sides[group]);
  double radius = guessed_radius(world, area_of(world, sides), settings);
  if (settings.initial_radius > 0.0) return radius;
  const double wanted = settings.coarsest_samples;
  std::vector<std::vector<DiscPoint>> level;
  for (int round = 0; round < radius_rounds && !task.cancelled(); ++round) {
    level = GroupSamplers(world, sides, settings, task).add_level(radius);
    const auto placed = static_cast<double>(count_of(level));
    if (placed < 1.0 || std::fabs(placed - wanted) <= radius_tolerance * wanted) break;
    radius *= std::sqrt(placed / wanted);
  }
  if (!(settings.feature_radius > 0.0) || !(settings.most_coarsest > settings.coarsest_samples)) return radius;
  const double by_features = settings.feature_radius * typical_distance(world, level, task);
  return std::clamp(by_features, radius * std::sqrt(wanted / settings.most_coarsest), radius);
}

/// Empty where the points of all levels that the settings ask for are not too many.
std::string refusal_of(const World& world, double area, const Settings& settings) {
  const double finest = std::ldexp(guessed_radius(world, area, settings), 1 - settings.levels);
  const double points = expected_density * area / (finest * finest);
  if (points <= most_points) return {};
  return fmt::format("levels={} with {} asks for about {:.2g} points, {:.2g} at most: lower levels, or {}", settings.levels,
                     settings.initial_radius > 0.0 ? fmt::format("initial_radius={}", settings.initial_radius)
                                                   : fmt::format("coarsest_samples={}", settings.coarsest_samples),
                     points, most_points, settings.initial_radius > 0.0 ? "raise initial_radius" : "coarsest_samples");
}

}  // namespace

void clear_of_backfaces(const World& world, std::span<const DiscPoint> points, std::span<std::uint8_t> clear, int rays,
                        Task& task) {
  task.parallel_chunks(points.size(), ray_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    const std::size_t count = range.end - range.begin;
    std::vector<Ray> along(count);
    std::vector<Hit> hits(count);
    for (std::size_t i = 0; i < count; ++i) {
      const DiscPoint& point = points[range.begin + i];
      along[i].origin = world.ray_origin(surface_sample(world, point.side.triangle, point.position, point.normal));
      along[i].direction = point.normal;
    }
    stream.closest_hits(along, hits);
    for (std::size_t i = 0; i < count; ++i) {
      const Frame frame = frame_along_edge(world, points[range.begin + i].side.triangle, along[i].direction);
      const bool inside = meets_black_back(world, hits[i], along[i].direction) &&
                          all_meet_black_backs(world, along[i].origin, 1, rays, stream,
                                               [&](int ray) { return frame.to_world(test_direction(ray)); });
      clear[range.begin + i] = inside ? 0 : 1;
    }
  });
}

Placement place_points(const World& world, const Groups& groups, const Settings& settings, Task& task) {
  const std::vector<std::vector<SurfaceSide>> sides = sides_of_groups(world, groups);
  Placement placement;
  placement.refusal = refusal_of(world, area_of(world, sides), settings);
  if (!placement.refusal.empty()) return placement;
  placement.radius = initial_radius(world, groups, sides, settings, task);
  GroupSamplers samplers(world, sides, settings, task);
  double radius = placement.radius;
  for (int level = 0; level < settings.levels && !task.cancelled(); ++level, radius *= 0.5) {
    placement.points.push_back(samplers.add_level(radius));
    task.progress("place points", 0.7 * (level + 1) / settings.levels);
  }
  placement.proposals = samplers.proposals();
  placement.inside = samplers.inside();
  return placement;
}

}  // namespace gibench::meshless
