#include "bench/measure/camera_points.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/measure/cancellation.h"
#include "common/core/error.h"
#include "common/core/parallel.h"
#include "common/core/random.h"
#include "common/geometry/camera_view.h"

namespace gibench {

namespace {

constexpr std::uint64_t stage_key = 0x63616d657261ULL;

/// Camera rays as the picture's rows ask for them.
class PinholeRays {
 public:
  PinholeRays(const Camera& camera, int strata, std::uint64_t seed)
      : camera_(camera), view_(camera), strata_(strata), seed_(seed) {}

  void append(int x, int y, std::vector<Ray>& rays) const {
    RandomStream random(
        seed_, stage_key,
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(camera_.width) + static_cast<std::uint64_t>(x));
    for (int j = 0; j < strata_; ++j)
      for (int i = 0; i < strata_; ++i) {
        const float u = (static_cast<float>(i) + random.next_float()) / static_cast<float>(strata_);
        const float v = (static_cast<float>(j) + random.next_float()) / static_cast<float>(strata_);
        const float across = 2.0F * (static_cast<float>(x) + u) / static_cast<float>(camera_.width) - 1.0F;
        const float upward = 1.0F - 2.0F * (static_cast<float>(y) + v) / static_cast<float>(camera_.height);
        rays.push_back({camera_.position, 0.0F, glm::normalize(view_.direction_at(across, upward))});
      }
  }

 private:
  Camera camera_;
  CameraView view_;
  int strata_;
  std::uint64_t seed_;
};

/// One row of the picture, `points` standing for that row alone.
CameraPoints trace_row(const World& world, const DirectLight& light, const PinholeRays& pinhole, int width, int row,
                       int rays_per_pixel) {
  CameraPoints points;
  std::vector<Ray> rays;
  for (int x = 0; x < width; ++x) pinhole.append(x, row, rays);
  std::vector<Hit> hits(rays.size());
  world.rays().closest_hits(rays, hits);
  points.background.assign(static_cast<std::size_t>(width), Rgb());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::size_t x = i / static_cast<std::size_t>(rays_per_pixel);
    if (!hits[i]) {
      points.background[x] += light.environment(rays[i].direction) / static_cast<float>(rays_per_pixel);
      continue;
    }
    points.samples.push_back(world.sample_of_hit(hits[i], rays[i].direction));
    points.toward_viewer.push_back(-rays[i].direction);
    points.pixel.push_back(static_cast<std::uint32_t>(row * width) + static_cast<std::uint32_t>(x));
  }
  return points;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Rgb> CameraPoints::pixel_means(std::span<const Rgb> at_samples) const {
  GIBENCH_CHECK(at_samples.size() == samples.size(), "one value for each camera sample");
  std::vector<Rgb> means(pixel_count());
  for (std::size_t i = 0; i < at_samples.size(); ++i) means[pixel[i]] += at_samples[i];
  for (Rgb& mean : means) mean /= static_cast<float>(rays_per_pixel);
  return means;
}

std::vector<Rgb> CameraPoints::pixel_variances(std::span<const Rgb> at_samples) const {
  std::vector<Rgb> variances = pixel_means(at_samples);
  for (Rgb& variance : variances) variance /= static_cast<float>(rays_per_pixel);
  return variances;
}

int strata_per_side(int rays_per_pixel, const char* place) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(rays_per_pixel))));
  if (rays_per_pixel < 1 || side * side != rays_per_pixel)
    throw InputError(place, fmt::format("{} is not a square number", rays_per_pixel),
                     "write 1, 4, 9, 16, …: camera rays stand in a square");
  return side;
}

CameraPoints camera_points(const World& world, const DirectLight& light, const Camera& camera, int rays_per_pixel,
                           std::uint64_t seed, int threads) {
  const int strata = strata_per_side(rays_per_pixel, "--pixel-samples");
  const PinholeRays pinhole(camera, strata, seed);
  const auto rows = static_cast<std::size_t>(camera.height);
  std::vector<CameraPoints> by_row(rows);
  parallel_chunks(threads, rows, 1, [&](const ChunkRange& range) {
    stop_if_cancelled();
    by_row[range.begin] = trace_row(world, light, pinhole, camera.width, static_cast<int>(range.begin), rays_per_pixel);
  });
  CameraPoints points;
  points.width = camera.width, points.height = camera.height, points.rays_per_pixel = rays_per_pixel;
  for (const CameraPoints& row : by_row) {
    append(points.samples, row.samples);
    append(points.toward_viewer, row.toward_viewer);
    append(points.pixel, row.pixel);
    append(points.background, row.background);
  }
  return points;
}

}  // namespace gibench
