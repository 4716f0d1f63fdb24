#include "methods/antiradiance/glossy_sources.h"

#include <algorithm>
#include <vector>

#include "common/core/sobol.h"
#include "common/finite_elements/surface_point.h"
#include "common/lighting/scene_lights.h"
#include "common/scene/light_kinds.h"
#include "methods/antiradiance/bin_transport.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 8;
constexpr std::uint64_t lobe_stage = 0x6c6f6265ULL;
constexpr std::uint32_t light_place = 0, light_choice = 1, pairs_of_group = 2;  // dimension pairs
constexpr std::ptrdiff_t most_visited = 64;                                     // punctual lights that are each given a ray

PunctualLights visits(const Lighting& lighting) {
  const auto punctual = std::count_if(lighting.lights.begin(), lighting.lights.end(),
                                      [](const Light& light) { return !kind_of(light).background; });
  return punctual <= most_visited ? PunctualLights::visited : PunctualLights::sampled;
}

/// Irradiance at one point, light sample by light sample, into the bins.
class PointLightGatherer {
 public:
  PointLightGatherer(const World& world, const SceneLights& lights, const DirectSources& sources, RayStream& rays)
      : world_(world), lights_(lights), sources_(sources), rays_(rays) {}

  void gather(const SurfaceSample& sample, std::uint64_t key, float share, LeafLobe& lobe, float* exitant) {
    const Vec3 origin = world_.ray_origin(sample);
    const auto add = [&](const LightSample& light, float weight) {
      const float cosine = glm::dot(light.direction, sample.normal);
      if (!(light.pdf > 0.0F && cosine > 0.0F) || is_black(light.radiance)) return;
      if (sources_.tests_visibility && rays_.occluded(light.shadow_ray(origin))) return;
      lobe.reflect(light.direction, light.radiance * (weight * cosine / light.pdf), exitant);
    };
    for (std::size_t light = 0; light < lights_.punctual_count(); ++light) add(lights_.punctual(light, sample.position), share);
    const SobolSequence random(key);
    const auto count = static_cast<std::uint32_t>(sources_.samples);
    std::uint32_t dimensions = 0;
    for (const LightGroup group : lights_.groups()) {
      for (std::uint32_t i = 0; i < count; ++i)
        add(lights_.sample(group, sample.position, sample.normal, random.pair(i, dimensions + light_choice).x,
                           random.pair(i, dimensions + light_place).unit()),
            share / static_cast<float>(count));
      dimensions += pairs_of_group;
    }
  }

 private:
  const World& world_;
  const SceneLights& lights_;
  const DirectSources& sources_;
  RayStream& rays_;
};

}  // namespace

Vector glossy_direct_radiance(const World& world, const DirectSources& sources, const Elements& elements,
                              const Hierarchy& hierarchy, const GlossyReflection& glossy, const DirectionBins& bins, Task& task) {
  const SceneLights lights(world, sources.lighting, visits(sources.lighting));
  const std::size_t row = bins.count() * channels;
  Vector radiance = Vector::Zero(static_cast<Eigen::Index>(hierarchy.leaf_count() * row));
  task.parallel_chunks(hierarchy.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    PointLightGatherer gatherer(world, lights, sources, rays);
    std::vector<float> projected(bins.count());
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      if (!glossy.is_glossy(leaf)) continue;
      const std::uint32_t element = hierarchy.order()[leaf];
      const Vec3& normal = hierarchy.nodes()[hierarchy.leaf_node(leaf)].normal;
      projected_bins(bins, normal, projected);
      LeafLobe lobe(glossy, leaf, normal, projected);
      const auto points = elements.points(element);
      const auto exposed = std::count_if(points.begin(), points.end(), [](const CellPoint& point) { return point.exposed; });
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].exposed) continue;
        const SurfaceSample sample =
            surface_sample(world, points[k].triangle, 0.5F * (points[k].origin + points[k].behind), points[k].normal);
        gatherer.gather(sample, mix_keys(task.seed(), lobe_stage, element * points.size() + k),
                        1.0F / static_cast<float>(exposed), lobe, radiance.data() + leaf * row);
      }
    }
  });
  return radiance;
}

}  // namespace gibench::antiradiance
