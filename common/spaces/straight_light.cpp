#include "common/spaces/straight_light.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/core/random.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

constexpr std::uint64_t straight_stage = 0x7370616365646972ULL;

/// The lights without a size, or the others.
Lighting lights_of(const Scene& scene, bool punctual) {
  Lighting lighting = Lighting::of(scene);
  std::erase_if(lighting.lights, [&](const Light& light) { return kind_of(light).background == punctual; });
  if (punctual) std::ranges::fill(lighting.emission, Rgb());
  return lighting;
}

}  // namespace

StraightLight::StraightLight(const World& world, const CellPoints& points, std::uint64_t seed)
    : points_(points),
      seed_(seed),
      punctual_(world, lights_of(world.scene(), true)),
      extended_(world, lights_of(world.scene(), false)) {}

void StraightLight::find(const CellRange& cells, std::span<float> of_points, RayStream& rays) const {
  if (!punctual_.dark()) find_of(punctual_, true, cells, of_points, rays);
  if (!extended_.dark()) find_of(extended_, false, cells, of_points, rays);
}

void StraightLight::find_of(const DirectLight& light, bool from_points, const CellRange& cells, std::span<float> of_points,
                            RayStream& rays) const {
  const std::uint32_t each = points_.points_a_cell();
  const std::size_t first = cells.begin * each, count = (cells.end - cells.begin) * each;
  std::vector<SurfaceSample> samples;
  std::vector<std::uint64_t> keys;
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<SurfaceSample> sample = points_.sample(static_cast<std::uint32_t>(first + i));
    if (!sample) continue;
    samples.push_back(*sample);
    keys.push_back(mix_keys(mix_keys(seed_, from_points ? 1 : 0), straight_stage, first + i));
    place.push_back(i);
  }
  std::vector<Rgb> found(samples.size());
  light.irradiance(samples, keys, 1, rays, found);
  std::vector<float> values(count, 0.0F);
  for (std::size_t i = 0; i < found.size(); ++i) values[place[i]] = mean_of_channels(found[i]);
  for (std::size_t cell = cells.begin; cell < cells.end; ++cell) {
    const std::span<float> own = std::span(values).subspan((cell - cells.begin) * each, each);
    even_out(light, from_points, static_cast<std::uint32_t>(cell), own, rays);
    for (std::uint32_t i = 0; i < each; ++i) of_points[cell * each + i] += own[i];
  }
}

void StraightLight::even_out(const DirectLight& light, bool from_points, std::uint32_t cell, std::span<float> values,
                             RayStream& rays) const {
  const auto is_lit = [](float value) { return value > 0.0F; };
  auto lit = static_cast<std::size_t>(std::ranges::count_if(values, is_lit));
  if (lit == 0 || (lit == values.size() && lit > 1)) return;
  const std::size_t more = 4 * values.size();
  float sum = 0.0F, count = 0.0F;
  for (std::uint32_t i = 0; i < values.size(); ++i)
    if (points_.sample(cell * points_.points_a_cell() + i)) sum += values[i], count += 1.0F;
  for (std::size_t i = 0; i < more; ++i) {
    const std::optional<SurfaceSample> sample = points_.another(cell, i, seed_);
    if (!sample) continue;
    const std::uint64_t key = mix_keys(mix_keys(seed_, from_points ? 3 : 2), straight_stage, std::uint64_t{cell} * more + i);
    const float value = mean_of_channels(light.irradiance(*sample, key, 1, rays));
    sum += value, count += 1.0F;
    if (is_lit(value)) ++lit;
  }
  if (from_points && lit <= 1) std::ranges::fill(values, 0.0F);
  else if (!points_.is_divided(cell)) std::ranges::fill(values, sum / count);
}

}  // namespace gibench
