#include "methods/spectral/trial_lights.h"

#include <array>
#include <cmath>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/sobol.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t light_stage = 0x747269616cULL, sky_stage = 0x736b79ULL;
constexpr std::uint32_t sky_rays = 64;
constexpr std::size_t usual_triples = 16, judge_triples = 8;
constexpr std::size_t slot_chunk = 512;

SurfaceSample centre_of(const World& world, const Transfer& transfer, std::uint32_t node) {
  const auto& [vertex, site] = transfer.nodes.sites(node).front();
  return transfer.mesh->sample(world, vertex, site);
}

/// Those that lights may stand above.
std::vector<std::uint32_t> reached_nodes(const Nodes& nodes) {
  std::vector<std::uint32_t> reached;
  for (std::uint32_t node = 0; node < nodes.size(); ++node)
    if (nodes[node].reached) reached.push_back(node);
  if (reached.empty())
    for (std::uint32_t node = 0; node < nodes.size(); ++node) reached.push_back(node);
  return reached;
}

/// Halfway along a ray from a surface: somewhere in the open.
Vec3 place_of_light(const World& world, const Transfer& transfer, std::span<const std::uint32_t> nodes, std::uint64_t number,
                    RayStream& rays, std::uint64_t seed) {
  RandomStream random(seed, light_stage, number);
  const auto which = static_cast<std::size_t>(random.next_double() * static_cast<double>(nodes.size()));
  const SurfaceSample from = centre_of(world, transfer, nodes[which]);
  const Vec3 direction = Frame(from.normal).to_world(cosine_hemisphere({random.next_float(), random.next_float()}));
  const Hit hit = rays.closest_hit({world.ray_origin(from), 0.0F, direction});
  return from.position + (0.5F * (hit ? hit.distance : 0.5F * world.diagonal())) * direction;
}

float irradiance_from(const Vec3& light, const World& world, const SurfaceSample& sample, float nearest, bool occlusion,
                      RayStream& rays) {
  const Vec3 origin = world.ray_origin(sample), toward = light - origin;
  const float squared = std::max(glm::dot(toward, toward), nearest * nearest);
  const float cosine = glm::dot(toward, sample.normal) / std::sqrt(squared);
  if (!(cosine > 0.0F) || (occlusion && rays.occluded({origin, 0.0F, toward, 1.0F}))) return 0.0F;
  return cosine / squared;
}

void scale_to_unit_mean(std::span<Rgb4> field, std::span<const double> area) {
  RgbDouble sum;
  double total = 0.0;
  for (std::size_t i = 0; i < field.size(); ++i) sum += RgbDouble(Rgb(field[i])) * area[i], total += area[i];
  const auto factor = [&](double s) { return s > 0.0 ? static_cast<float>(total / s) : 0.0F; };
  const Rgb scale(factor(sum.r), factor(sum.g), factor(sum.b));
  for (Rgb4& value : field) value = Rgb(value) * scale;
}

/// What a sky of three kinds brings to a point: all round, from above, and from one side.
Rgb irradiance_from_sky(const World& world, const SurfaceSample& sample, std::uint32_t node, bool occlusion, RayStream& rays) {
  const Frame frame(sample.normal);
  const SobolSequence directions(mix_keys(sky_stage, node));
  Rgb sum;
  for (std::uint32_t i = 0; i < sky_rays; ++i) {
    const Vec3 direction = frame.to_world(cosine_hemisphere(directions.pair(i, 0).unit()));
    const Ray ray{world.ray_origin(sample), 0.0F, direction};
    // Where nothing hides anything the ray asks which wall it meets, not whether it is free.
    if (occlusion ? rays.occluded(ray) : static_cast<bool>(rays.closest_hit(ray))) continue;
    sum += Rgb(1.0F, direction.y > 0.0F ? 1.0F : 0.0F, direction.x + direction.z > 0.0F ? 1.0F : 0.0F);
  }
  return sum;
}

}  // namespace

TrialLights trial_lights(const World& world, const Transfer& transfer, bool occlusion, Task& task) {
  const SpectralBasis& basis = transfer.basis;
  const std::vector<std::uint32_t> reached = reached_nodes(transfer.nodes);
  std::vector<double> area;
  for (std::uint32_t slot = 0; slot < basis.slots(); ++slot) area.push_back(static_cast<double>(transfer.node_at(slot).area));
  std::vector<Rgb4> field(basis.slots());
  // `light(sample, node, rays)`: the irradiance.
  const auto projected = [&](const auto& light) {
    task.parallel_chunks(field.size(), slot_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world);
      for (std::size_t slot = range.begin; slot < range.end; ++slot) {
        const std::uint32_t node = transfer.node_of_slot[slot];
        field[slot] = light(centre_of(world, transfer, node), node, rays);
      }
    });
    scale_to_unit_mean(field, area);
    std::vector<Rgb4> coefficients(basis.columns());
    basis.project(field, coefficients, task);
    return coefficients;
  };
  TrialLights lights;
  for (std::size_t triple = 0; triple < usual_triples + judge_triples; ++triple) {
    RayStream placing = task.rays(world);
    std::array<Vec3, 3> places{};
    for (std::size_t i = 0; i < 3; ++i)
      places[i] = place_of_light(world, transfer, reached, 3 * triple + i, placing, task.seed());
    (triple < usual_triples ? lights.usual : lights.judges)
        .push_back(projected([&](const SurfaceSample& sample, std::uint32_t node, RayStream& rays) {
          const float nearest = std::sqrt(transfer.nodes[node].area);
          const auto from = [&](std::size_t i) { return irradiance_from(places[i], world, sample, nearest, occlusion, rays); };
          return Rgb(from(0), from(1), from(2));
        }));
  }
  lights.judges.push_back(projected([&](const SurfaceSample& sample, std::uint32_t node, RayStream& rays) {
    return irradiance_from_sky(world, sample, node, occlusion, rays);
  }));
  lights.usual.push_back(lights.judges.back());
  return lights;
}

TrialLights with_ambient(TrialLights lights, const SpectralBasis& basis, float ambient) {
  const std::vector<float> constant = basis.constant();
  for (auto* set : {&lights.usual, &lights.judges})
    for (std::vector<Rgb4>& light : *set)
      for (std::size_t c = 0; c < light.size(); ++c) light[c] = Rgb(light[c]) + Rgb(ambient * constant[c]);
  return lights;
}

}  // namespace gibench::spectral
