#include "methods/meshless/light_at_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/random.h"
#include "common/finite_elements/surface_point.h"

namespace gibench::meshless {

namespace {

constexpr std::uint64_t gather_stage = 0x676174686572ULL;
constexpr std::uint64_t direct_stage = 0x64697265637473ULL;
constexpr std::size_t gather_chunk = 4;   // points
constexpr int least_rays = 64;            // of a gather on a fine level
constexpr std::size_t direct_chunk = 64;  // points
constexpr double gather_noise = 0.03;     // that direct light evaluated at the hits may bring into a gather, of the mean
constexpr double most_hit_samples = 4.0;  // at a hit, to keep to that; noisier direct light goes through the basis …
constexpr double point_noise = 0.3;       // … with this much noise at a basis point: a gather sees hundreds of them
constexpr double most_point_samples = 1024.0;
constexpr double most_variance_growth = 1.25;  // that fewer hemisphere samples may cost

/// By the levels below the first fine one. The squared noise of such a pattern falls with the 3/2nd power of its rays, and counts
/// for the area that a gather stands for, a quarter from level to level: its mean is least at a number of rays if these fall by
/// 2^(4/5) a level. That is where thresholds double; where they are the same on all levels, so are the rays.
int rays_of_fine_level(const Settings& settings, std::uint32_t level) {
  const double rays = settings.rays * std::pow(settings.level_growth, -0.8 * level);
  return std::max(std::min(settings.rays, least_rays), static_cast<int>(std::lround(rays)));
}

}  // namespace

LightAtPoints::LightAtPoints(const World& world, const Transport& transport, const DirectLight& light, const Settings& settings,
                             int channels, Task& task)
    : world_(world),
      transport_(transport),
      light_(light),
      settings_(settings),
      channels_(channels),
      task_(task),
      hit_samples_(settings.direct_samples),
      point_samples_(settings.basis_direct_samples) {
  const std::uint32_t levels = std::max(1U, coarse_levels(transport.hierarchy, settings));
  for (std::uint32_t level = 0; level < levels; ++level)
    gatherers_.emplace_back(world, std::max(settings.rays, settings.coarsest_rays >> level));
  for (std::uint32_t level = levels; level < transport.hierarchy.levels(); ++level)
    gatherers_.emplace_back(world, rays_of_fine_level(settings, level - levels));
  look_at_direct_light();
}

Coefficients LightAtPoints::direct() {
  const PointValues values = [this](std::span<const std::uint32_t> points, std::span<Estimate> out) {
    sample_direct(points, out);
  };
  RefinementRule own = rule();
  own.full_level = static_cast<std::uint32_t>(settings_.direct_full_level);
  return approximate(transport_.hierarchy, values, own, task_);
}

/// Estimates at the coarsest samples show how noisy one light sample is, and so how many are needed, and where; and whether that
/// grows where few of them have a hemisphere sample beside them, as where surfaces touch lamps or glow all around.
void LightAtPoints::look_at_direct_light() {
  double relative_variance = direct_variance();
  if (settings_.hemisphere_share < 1.0) {
    savings_.hemisphere_share = static_cast<float>(settings_.hemisphere_share);
    const double of_few = direct_variance();
    if (of_few > most_variance_growth * relative_variance + 1e-12) savings_.hemisphere_share = 1.0F;
    else relative_variance = of_few;
  }
  savings_.small_light = static_cast<float>(settings_.small_light * direct_mean_);
  const double at_hits = relative_variance / (settings_.rays * gather_noise * gather_noise);
  first_bounce_from_basis_ = settings_.first_bounce == FirstBounce::basis ||
                             (settings_.first_bounce == FirstBounce::automatic && at_hits > most_hit_samples);
  hit_samples_ = std::max(hit_samples_, static_cast<int>(std::ceil(std::min(at_hits, most_hit_samples))));
  const double at_points = std::min(relative_variance / (point_noise * point_noise), most_point_samples);
  point_samples_ = std::max(point_samples_, static_cast<int>(std::ceil(at_points)));
}

/// Of one light sample at the coarsest samples, relative to the square of the mean.
double LightAtPoints::direct_variance() {
  std::vector<std::uint32_t> points(transport_.hierarchy.level_size(0));
  std::iota(points.begin(), points.end(), 0U);
  std::vector<Estimate> values(points.size());
  sample_direct(points, values);
  double largest_mean = 0.0, variance = 0.0;
  direct_mean_ = 0.0;
  for (const std::uint32_t point : points) {
    const Estimate& estimate = values[point];
    const double share = transport_.hierarchy.coarsest_share(point);
    direct_mean_ += share * channel_mean(RgbDouble(estimate.value));
    largest_mean += share * static_cast<double>(largest(estimate.value));
    variance += share * std::pow(static_cast<double>(estimate.deviation), 2);
  }
  return largest_mean > 0.0 ? variance * point_samples_ / (largest_mean * largest_mean) : 0.0;
}

RefinementRule LightAtPoints::rule() const {
  RefinementRule made;
  made.epsilon_e = settings_.epsilon_e;
  made.noise_guard = settings_.noise_guard;
  made.corrections = settings_.corrections;
  made.threshold_mean = settings_.threshold_mean;
  made.proximity = settings_.proximity;
  made.level_growth = settings_.level_growth;
  made.channels = channels_;
  return made;
}

const Gatherer& LightAtPoints::gatherer_of(std::uint32_t point) const {
  return gatherers_[std::min(std::size_t{transport_.hierarchy.level_of(point)}, gatherers_.size() - 1)];
}

SurfaceSample LightAtPoints::sample(std::uint32_t point) const {
  const Hierarchy& hierarchy = transport_.hierarchy;
  const Vec3& front = world_.normal(hierarchy.triangle(point));
  return surface_sample(world_, hierarchy.triangle(point), hierarchy.position(point), hierarchy.on_front(point) ? front : -front);
}

void LightAtPoints::gather(const Sender& sender, int number, std::span<const std::uint32_t> points, std::span<Estimate> out,
                           std::span<HitKeeper* const> keepers) {
  for (HitKeeper* const keeper : keepers) keeper->announce(points);
  std::vector<std::uint64_t> levels(chunk_count(points.size(), gather_chunk)), evaluations(levels.size()),
      uncovered(levels.size());
  task_.parallel_chunks(points.size(), gather_chunk, [&](const ChunkRange& range) {
    RayStream rays = task_.rays(world_);
    GatherBuffers buffers;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const std::uint64_t key = mix_keys(mix_keys(task_.seed(), gather_stage), static_cast<std::uint64_t>(number), points[i]);
      const Gatherer& gatherer = gatherer_of(points[i]);
      buffers.reach = transport_.hierarchy.radius(points[i]);
      out[i] = gatherer.irradiance(sample(points[i]), key, sender, rays, buffers);
      for (HitKeeper* const keeper : keepers) keeper->keep(points[i], gatherer, buffers);
    }
    levels[range.chunk] = buffers.counts.levels_used;
    evaluations[range.chunk] = buffers.evaluations;
    uncovered[range.chunk] = buffers.counts.uncovered;
  });
  task_.count("samples_gathered", points.size());
  for (std::uint64_t count : levels) task_.count("sender_levels", count);
  for (std::uint64_t count : evaluations) task_.count("sender_evaluations", count);
  for (std::uint64_t count : uncovered) task_.count("uncovered_hits", count);
}

void LightAtPoints::sample_direct(std::span<const std::uint32_t> points, std::span<Estimate> out) {
  task_.parallel_chunks(points.size(), direct_chunk, [&](const ChunkRange& range) {
    RayStream rays = task_.rays(world_);
    direct_estimates(points.subspan(range.begin, range.end - range.begin), rays, out.subspan(range.begin));
  });
  task_.count("direct_samples", points.size());
}

/// Two independent halves give the value and its deviation.
void LightAtPoints::direct_estimates(std::span<const std::uint32_t> points, RayStream& rays, std::span<Estimate> out) const {
  std::vector<SurfaceSample> samples;
  std::vector<std::uint64_t> keys;
  for (const std::uint32_t point : points)
    for (const std::uint64_t half : {0U, 1U}) {
      samples.push_back(sample(point));
      keys.push_back(mix_keys(mix_keys(task_.seed(), direct_stage, point), half));
    }
  std::vector<Rgb> light(samples.size());
  light_.irradiance(samples, keys, std::max(1, point_samples_ / 2), rays, light, {savings_.hemisphere_share, 0.0F});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rgb &first = light[2 * i], &second = light[2 * i + 1], apart = first - second;
    out[i] = {0.5F * (first + second), 0.5F * std::max({std::fabs(apart.r), std::fabs(apart.g), std::fabs(apart.b)}), 0.0F};
  }
}

}  // namespace gibench::meshless
