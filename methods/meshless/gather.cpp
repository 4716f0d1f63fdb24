#include "methods/meshless/gather.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/sobol.h"
#include "common/finite_elements/morton.h"
#include "common/finite_elements/surface_point.h"
#include "methods/meshless/edge_frame.h"

namespace gibench::meshless {

namespace {

constexpr std::size_t parts = 4;  // of a pattern, to judge the deviation from
constexpr std::size_t bin_rays = 8;
constexpr float shortest_distance = 1e-4F;  // of the diagonal: what is nearer counts as being so far away
constexpr std::uint64_t turn_stage = 0x7475726eULL;
constexpr std::uint64_t direct_stage = 0x6869742064697265ULL;

/// By the cell of a 256 × 256 grid over the disc.
std::uint64_t along_curve(const Vec3& direction) {
  const auto cell = [](float x) { return static_cast<std::uint32_t>(std::clamp(0.5F * (x + 1.0F), 0.0F, 1.0F) * 255.0F); };
  return along_morton_curve(cell(direction.y), cell(direction.x));
}

/// Mean of the parts' sums and the deviation of that mean, were the parts independent.
Estimate estimate_of(const std::array<RgbDouble, parts>& sums, std::size_t rays) {
  RgbDouble total;
  for (const RgbDouble& sum : sums) total += sum;
  double variance = 0.0;  // of the sum, largest channel
  for (int channel = 0; channel < 3; ++channel) {
    double squares = 0.0;
    for (const RgbDouble& sum : sums) squares += std::pow(sum[channel] - total[channel] / parts, 2);
    variance = std::max(variance, squares * parts / (parts - 1));
  }
  const auto count = static_cast<double>(rays);
  return {Rgb(total / count), static_cast<float>(std::sqrt(variance) / count), 0.0F};
}

}  // namespace

void BasisSender::irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t, RayStream&,
                             std::span<Rgb> values, SenderCounts& counts) const {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const SurfaceSample& hit = hits[i];
    const Place at{hit.position, hit.normal, groups_.of(hit)};
    const std::uint64_t before = counts.levels_used;
    values[i] = expansion_.evaluate_seen(at, receiver, epsilon_omega_, counts.levels_used);
    if (counts.levels_used == before && !hierarchy_.covered(at)) ++counts.uncovered;
  }
}

void DirectSender::irradiance(std::span<const SurfaceSample> hits, const Vec3&, std::uint64_t key, RayStream& rays,
                              std::span<Rgb> values, SenderCounts&) const {
  std::vector<std::uint64_t> keys(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) keys[i] = mix_keys(key, direct_stage, i);
  light_.irradiance(hits, keys, samples_, rays, values, savings_);
}

void BothSenders::irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t key, RayStream& rays,
                             std::span<Rgb> values, SenderCounts& counts) const {
  first_.irradiance(hits, receiver, key, rays, values, counts);
  std::vector<Rgb> more(values.size());
  second_.irradiance(hits, receiver, key, rays, more, counts);
  for (std::size_t i = 0; i < more.size(); ++i) values[i] += more[i];
}

Gatherer::Gatherer(const World& world, int rays) : world_(world) {
  for (int i = 0; i < rays; ++i) {
    const float radical_inverse = static_cast<float>(reverse_bits(static_cast<std::uint32_t>(i))) * 0x1p-32F;
    pattern_.push_back(cosine_hemisphere({(static_cast<float>(i) + 0.5F) / static_cast<float>(rays), radical_inverse}));
  }
  std::stable_sort(pattern_.begin(), pattern_.end(),
                   [](const Vec3& a, const Vec3& b) { return along_curve(a) < along_curve(b); });
}

void Gatherer::trace(const SurfaceSample& receiver, std::uint64_t key, RayStream& rays, GatherBuffers& buffers) const {
  const Vec3 origin = world_.ray_origin(receiver);
  const Frame frame = frame_along_edge(world_, receiver.triangle, receiver.normal);
  const float angle = 2.0F * pi * RandomStream(key, turn_stage, 0).next_float();
  const Vec3 tangent = std::cos(angle) * frame.tangent + std::sin(angle) * frame.bitangent;
  const Vec3 bitangent = glm::cross(receiver.normal, tangent);
  buffers.rays.resize(pattern_.size());
  buffers.hits.resize(pattern_.size());
  for (std::size_t i = 0; i < pattern_.size(); ++i) {
    const Vec3& local = pattern_[i];
    buffers.rays[i].origin = origin;
    buffers.rays[i].direction = local.x * tangent + local.y * bitangent + local.z * receiver.normal;
  }
  rays.closest_hits(buffers.rays, buffers.hits);
}

Estimate Gatherer::irradiance(const SurfaceSample& receiver, std::uint64_t key, const Sender& sender, RayStream& rays,
                              GatherBuffers& buffers) const {
  trace(receiver, key, rays, buffers);
  collect_lit_hits(buffers);
  buffers.values.resize(buffers.lit.size());
  sender.irradiance(buffers.lit, receiver.position, key, rays, buffers.values, buffers.counts);
  buffers.evaluations += buffers.lit.size();
  std::array<RgbDouble, parts> sums;
  for (std::size_t i = 0; i < buffers.lit.size(); ++i)
    sums[buffers.ray_of_lit[i] % parts] += RgbDouble(buffers.albedos[i] * buffers.values[i]);
  Estimate made = estimate_of(sums, pattern_.size());
  made.slope = slope(buffers, buffers.bins);
  return made;
}

/// Directions are taken together in bins of neighbours, so that the noise of single hits does not count as unlikeness.
float Gatherer::slope(const GatherBuffers& buffers, GatherBuffers::Bins& bins) const {
  const std::size_t count = (pattern_.size() + bin_rays - 1) / bin_rays;
  bins.light.assign(count, 0.0F);
  bins.nearness.assign(count, 0.0F);
  const float shortest = std::max(buffers.reach, shortest_distance * world_.diagonal());
  for (std::size_t i = 0; i < buffers.hits.size(); ++i)
    if (buffers.hits[i]) bins.nearness[i / bin_rays] += 1.0F / std::max(shortest, buffers.hits[i].distance);
  for (std::size_t i = 0; i < buffers.lit.size(); ++i) {
    const Rgb light = buffers.albedos[i] * buffers.values[i];
    bins.light[buffers.ray_of_lit[i] / bin_rays] += (light.r + light.g + light.b) / 3.0F;
  }
  float mean = 0.0F, sum = 0.0F;
  for (const float light : bins.light) mean += light / static_cast<float>(pattern_.size());
  for (std::size_t bin = 0; bin < count; ++bin) {
    const auto rays = static_cast<float>(std::min(bin_rays, pattern_.size() - bin * bin_rays));
    sum += std::fabs(bins.light[bin] - rays * mean) * bins.nearness[bin] / rays;
  }
  return sum / static_cast<float>(pattern_.size());
}

Estimate Gatherer::reflectance(const GatherBuffers& buffers) const {
  std::array<RgbDouble, parts> sums;
  for (std::size_t i = 0; i < buffers.lit.size(); ++i) sums[buffers.ray_of_lit[i] % parts] += RgbDouble(buffers.albedos[i]);
  return estimate_of(sums, pattern_.size());
}

/// Keeps the hits on lit sides that reflect.
void Gatherer::collect_lit_hits(GatherBuffers& buffers) const {
  buffers.lit.clear();
  buffers.albedos.clear();
  buffers.ray_of_lit.clear();
  const Scene& scene = world_.scene();
  for (std::size_t i = 0; i < buffers.hits.size(); ++i) {
    const Hit& hit = buffers.hits[i];
    if (!hit) continue;
    const Vec3& direction = buffers.rays[i].direction;
    const Rgb albedo = scene.material_of_triangle(hit.triangle).diffuse;
    if (is_black(albedo)) continue;
    const Vec3& front = world_.normal(hit.triangle);
    const bool on_front = glm::dot(front, direction) <= 0.0F;
    if (!on_front && !scene.objects[scene.triangle_object[hit.triangle]].two_sided) continue;
    const Vec3 position = buffers.rays[i].origin + hit.distance * direction;
    buffers.lit.push_back(surface_sample(world_, hit.triangle, position, on_front ? front : -front));
    buffers.albedos.push_back(albedo);
    buffers.ray_of_lit.push_back(static_cast<std::uint32_t>(i));
  }
}

}  // namespace gibench::meshless
