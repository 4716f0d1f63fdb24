#include "common/spaces/side_light_making.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/geometry/camera_sight.h"
#include "common/geometry/camera_view.h"
#include "common/scene/material_kinds.h"
#include "common/spaces/cell_points.h"
#include "common/spaces/straight_light.h"

namespace gibench {

namespace {

constexpr std::uint64_t ray_stage = 0x7370616365726179ULL;
constexpr std::size_t most_rays_a_cell = 24, least_rays_a_cell = 4, usual_rays = 4'000'000;
constexpr std::size_t points_a_chunk = 256, cells_a_chunk = 64;
constexpr int camera_grid = 128;  // rays across and down a picture
constexpr int most_rounds = 32;
constexpr double settled_change = 1e-4;  // of the sum of irradiance

std::size_t rays_of_cells(std::size_t cells) {
  return std::clamp(usual_rays / std::max<std::size_t>(1, cells), least_rays_a_cell, most_rays_a_cell);
}

class CellLightMaker {
 public:
  CellLightMaker(const World& world, const SideCells& cells, Task& task)
      : world_(world),
        cells_(cells),
        task_(task),
        views_(camera_views(world.scene())),
        sight_(world),
        points_(world, cells, rays_of_cells(cells.size()) >= 8 ? 4 : 1, task),
        rays_a_point_(rays_of_cells(cells.size()) / points_.points_a_cell()),
        irradiance_(points_.size(), 0.0F) {
    light_.seen.assign(cells.size(), 0);
  }

  CellLight make() {
    look_from_cameras();
    find_straight_light();
    trace_rays();
    look_by_reflection();
    reflect();
    sum_up();
    return std::move(light_);
  }

 private:
  template <class Body>
  void each_point(const Body& body) {
    task_.parallel_chunks(points_.size(), 16 * points_a_chunk, [&](const ChunkRange& range) {
      for (auto point = static_cast<std::uint32_t>(range.begin); point < range.end; ++point) body(point);
    });
  }

  void look_from_cameras() {
    for (const CameraView& view : views_) {
      task_.parallel_chunks(camera_grid, 1, [&](const ChunkRange& range) {
        RayStream rays = task_.rays(world_);
        std::array<Ray, camera_grid> row;
        std::array<Hit, camera_grid> hits;
        for (std::size_t x = 0; x < row.size(); ++x)
          row[x] = {view.position, 0.0F, view.direction_at(in_picture(x), in_picture(range.begin))};
        rays.closest_hits(row, hits);
        for (std::size_t x = 0; x < row.size(); ++x)
          if (const std::uint32_t cell = cell_of(hits[x], row[x].direction); cell != SideCells::none) mark_seen(cell);
      });
    }
  }
  static float in_picture(std::size_t i) { return (2.0F * static_cast<float>(i) + 1.0F) / camera_grid - 1.0F; }
  /// By several threads at once.
  void mark_seen(std::uint32_t cell) { std::atomic_ref(light_.seen[cell]).store(1, std::memory_order_relaxed); }

  std::uint32_t cell_of(const Hit& hit, const Vec3& direction) const {
    if (!hit) return SideCells::none;
    return cells_.at(hit.triangle, glm::dot(world_.normal(hit.triangle), direction) <= 0.0F, {hit.u, hit.v});
  }

  void find_straight_light() {
    const StraightLight light(world_, points_, task_.seed());
    task_.parallel_chunks(cells_.size(), cells_a_chunk, [&](const ChunkRange& range) {
      RayStream rays = task_.rays(world_);
      light.find({range.begin, range.end}, irradiance_, rays);
      for (std::size_t point = range.begin * points_.points_a_cell(); point < range.end * points_.points_a_cell(); ++point) {
        const std::optional<SurfaceSample> sample = points_.sample(static_cast<std::uint32_t>(point));
        if (sample && sight_.sees(*sample, rays)) mark_seen(points_.cell(static_cast<std::uint32_t>(point)));
      }
    });
  }

  /// The points that the rays of each point meet.
  void trace_rays() {
    met_.assign(points_.size() * rays_a_point_, CellPoints::none);
    task_.parallel_chunks(points_.size(), points_a_chunk, [&](const ChunkRange& range) {
      RayStream stream = task_.rays(world_);
      std::vector<Ray> rays(rays_a_point_);
      std::vector<Hit> hits(rays_a_point_);
      for (auto point = static_cast<std::uint32_t>(range.begin); point < range.end; ++point) {
        const std::optional<SurfaceSample> sample = points_.sample(point);
        if (!sample) continue;
        RandomStream random(task_.seed(), ray_stage, point);
        const Frame frame(sample->normal);
        for (Ray& ray : rays) {
          const float u = random.next_float(), v = random.next_float();
          ray = {world_.ray_origin(*sample), 0.0F, frame.to_world(cosine_hemisphere({u, v}))};
        }
        stream.closest_hits(rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i)
          met_[point * rays_a_point_ + i] = points_.met(hits[i], rays[i].direction, stream);
      }
    });
  }

  std::span<const std::uint32_t> met_by(std::size_t point) const {
    return std::span(met_).subspan(point * rays_a_point_, rays_a_point_);
  }
  bool reflects(std::uint32_t cell) const { return can_reflect(world_, cells_.triangle(cell), cells_.front(cell)); }

  /// What meets seen sides that can reflect.
  void look_by_reflection() {
    if (views_.empty()) return;
    const std::vector<std::uint8_t> seen = light_.seen;
    each_point([&](std::uint32_t point) {
      for (const std::uint32_t met : met_by(point))
        if (met != CellPoints::none && seen[points_.cell(met)] != 0 && reflects(points_.cell(met)))
          mark_seen(points_.cell(point));
    });
  }

  /// Rounds of reflections, until little is added.
  void reflect() {
    std::vector<float> albedo(points_.size()), radiosity(points_.size()), next(points_.size());
    each_point([&](std::uint32_t point) {
      if (const std::uint32_t cell = points_.cell(point); reflects(cell))
        albedo[point] = mean_of_channels(straight_reflectance(world_.scene().material_of_triangle(cells_.triangle(cell))));
    });
    const std::vector<float> straight = irradiance_;
    double sum = total();
    for (int round = 0; round < most_rounds && !task_.cancelled(); ++round) {
      each_point([&](std::uint32_t point) { radiosity[point] = albedo[point] * irradiance_[point]; });
      each_point([&](std::uint32_t point) {
        float arriving = 0.0F;
        for (const std::uint32_t met : met_by(point))
          if (met != CellPoints::none) arriving += radiosity[met];
        next[point] = straight[point] + arriving / static_cast<float>(rays_a_point_);
      });
      irradiance_.swap(next);
      const double before = sum;
      sum = total();
      if (sum - before <= settled_change * sum) break;
    }
  }
  double total() const {
    double sum = 0.0;
    for (std::uint32_t point = 0; point < irradiance_.size(); ++point)
      sum += static_cast<double>(irradiance_[point]) * static_cast<double>(cells_.area(points_.cell(point)));
    return sum;
  }

  /// From points to cells; the parts of a cell that lie behind another surface do not count.
  void sum_up() {
    light_.irradiance.assign(cells_.size(), 0.0F);
    light_.brightest.assign(cells_.size(), 0.0F);
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      float sum = 0.0F, brightest = 0.0F, count = 0.0F;
      const std::uint32_t first = cell * points_.points_a_cell();
      for (std::uint32_t point = first; point < first + points_.points_a_cell(); ++point) {
        if (!points_.sample(point)) continue;
        sum += irradiance_[point], count += 1.0F;
        brightest = std::max(brightest, irradiance_[point]);
      }
      if (count == 0.0F) continue;
      light_.irradiance[cell] = sum / count;
      light_.brightest[cell] = points_.is_divided(cell) ? brightest : sum / count;
    }
  }

  const World& world_;
  const SideCells& cells_;
  Task& task_;
  std::vector<CameraView> views_;
  CameraSight sight_;
  CellPoints points_;
  std::size_t rays_a_point_;
  std::vector<std::uint32_t> met_;  ///< points, rays_a_point_ of each; none: nothing, or a black back
  std::vector<float> irradiance_;   ///< of every point, W/m²
  CellLight light_;
};

}  // namespace

CellLight light_of_cells(const World& world, const SideCells& cells, Task& task) {
  return CellLightMaker(world, cells, task).make();
}

bool can_reflect(const World& world, std::uint32_t triangle, bool front) {
  const Scene& scene = world.scene();
  return front || scene.objects[scene.triangle_object[triangle]].two_sided;
}

}  // namespace gibench
