#include "methods/spectral/compression.h"

#include <algorithm>
#include <cmath>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/sobol.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t light_stage = 0x747269616cULL, sky_stage = 0x736b79ULL;
constexpr std::uint32_t sky_rays = 64;
constexpr std::size_t light_triples = 4;  // and one of skies
constexpr std::size_t slot_chunk = 512;
constexpr int halvings = 24;
constexpr double most_levels = 16000.0;  // of 32767: rows to come may hold larger values than the pilot's
constexpr double least_spread = 1e-3;    // of the largest: no function is taken to carry nothing

/// Halfway along a ray from a surface: somewhere in the open.
Vec3 place_of_light(const World& world, const SamplingMesh& mesh, std::uint64_t number, RayStream& rays, std::uint64_t seed) {
  RandomStream random(seed, light_stage, number);
  const auto vertices = static_cast<double>(mesh.vertices().size());
  const auto vertex = static_cast<std::uint32_t>(random.next_double() * vertices);
  const SurfaceSample from = mesh.sample(world, vertex, mesh.sites(vertex).front());
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

/// Root mean square of the coefficients by order in the part, over the part's weight, for every column.
std::vector<double> spread_of_columns(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights) {
  std::vector<double> part_weight, squares, weights;
  for (const SpectralBasis::Part& part : basis.parts()) {
    double sum = 0.0;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) sum += static_cast<double>(basis.weight()[slot]);
    part_weight.push_back(sum);
    if (squares.size() < part.width) squares.resize(part.width, 0.0), weights.resize(part.width, 0.0);
    for (std::uint32_t order = 0; order < part.functions; ++order) {
      weights[order] += sum;
      for (const auto& light : lights) {
        const RgbDouble c(Rgb(light[part.column + order]));
        squares[order] += c.r * c.r + c.g * c.g + c.b * c.b;
      }
    }
  }
  double largest = 0.0;
  for (std::size_t order = 0; order < squares.size(); ++order) {
    squares[order] = weights[order] > 0.0 ? std::sqrt(squares[order] / weights[order]) : 0.0;
    largest = std::max(largest, squares[order]);
  }
  std::vector<double> spread(basis.columns(), 1.0);
  for (std::size_t p = 0; p < basis.parts().size(); ++p) {
    const SpectralBasis::Part& part = basis.parts()[p];
    for (std::uint32_t order = 0; order < part.width; ++order) {
      const double usual = std::max({squares[order], least_spread * largest, 1e-30}) * std::sqrt(part_weight[p]);
      double own = 0.0;  // more than usual in parts that a light is close to
      for (const auto& light : lights) {
        const RgbDouble c(Rgb(light[part.column + order]));
        own += c.r * c.r + c.g * c.g + c.b * c.b;
      }
      spread[part.column + order] = std::max(usual, std::sqrt(own));
    }
  }
  return spread;
}

RgbDouble answer_to(const std::vector<Rgb4>& light, std::span<const float> row) {
  RgbDouble sum;
  for (std::size_t c = 0; c < row.size(); ++c) sum += RgbDouble(Rgb(light[c])) * static_cast<double>(row[c]);
  return sum;
}

/// What rounding adds to the squared error of the rows' answers to a light, as a share of their squares: of the light that it
/// hurts most.
double added_error(std::span<const PilotRow> rows, const std::vector<std::vector<Rgb4>>& lights, std::span<const float> steps) {
  std::vector<RgbDouble> squares(lights.size()), added(lights.size());
  std::vector<float> change(steps.size());
  for (const PilotRow& row : rows) {
    for (std::size_t c = 0; c < steps.size(); ++c)
      change[c] = std::nearbyint(row.values[c] / steps[c]) * steps[c] - row.values[c];
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const RgbDouble whole = answer_to(lights[i], row.values), off = answer_to(lights[i], change);
      // (x − A)(x − B) of the rounded answer less that of the answer itself.
      RgbDouble doubted = off;
      for (const std::vector<float>& other : row.others)
        if (!other.empty()) doubted += whole - answer_to(lights[i], other);
      squares[i] += row.area * (whole * whole);
      added[i] += row.area * (off * doubted);
    }
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < lights.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (squares[i][c] > 0.0) worst = std::max(worst, added[i][c] / squares[i][c]);
  return std::sqrt(worst);
}

/// What a sky of three kinds brings to a point: all round, from above, and from one side.
Rgb irradiance_from_sky(const World& world, const SurfaceSample& sample, std::uint32_t vertex, bool occlusion, RayStream& rays) {
  const Frame frame(sample.normal);
  const SobolSequence directions(mix_keys(sky_stage, vertex));
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

std::vector<std::vector<Rgb4>> trial_lights(const World& world, const SamplingMesh& mesh, const SpectralBasis& basis,
                                            std::span<const std::uint32_t> vertex_of_slot, bool occlusion, Task& task) {
  std::vector<std::vector<Rgb4>> lights;
  std::vector<double> area;
  for (const std::uint32_t vertex : vertex_of_slot) area.push_back(static_cast<double>(mesh.vertices()[vertex].area));
  std::vector<Rgb4> field(basis.slots());
  for (std::size_t triple = 0; triple <= light_triples; ++triple) {
    const bool skies = triple == light_triples;
    std::array<Vec3, 3> places{};
    if (!skies) {
      RayStream rays = task.rays(world);
      for (std::size_t i = 0; i < 3; ++i) places[i] = place_of_light(world, mesh, 3 * triple + i, rays, task.seed());
    }
    task.parallel_chunks(field.size(), slot_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world);
      for (std::size_t slot = range.begin; slot < range.end; ++slot) {
        const std::uint32_t vertex = vertex_of_slot[slot];
        const SurfaceSample sample = mesh.sample(world, vertex, mesh.sites(vertex).front());
        const float nearest = std::sqrt(mesh.vertices()[vertex].area);
        const auto from = [&](std::size_t i) { return irradiance_from(places[i], world, sample, nearest, occlusion, rays); };
        field[slot] = skies ? irradiance_from_sky(world, sample, vertex, occlusion, rays) : Rgb(from(0), from(1), from(2));
      }
    });
    scale_to_unit_mean(field, area);
    basis.project(field, lights.emplace_back(basis.columns()), task);
  }
  return lights;
}

std::vector<std::vector<Rgb4>> with_ambient(std::vector<std::vector<Rgb4>> lights, const SpectralBasis& basis, float ambient) {
  const std::vector<float> constant = basis.constant();
  for (std::vector<Rgb4>& light : lights)
    for (std::size_t c = 0; c < light.size(); ++c) light[c] = Rgb(light[c]) + Rgb(ambient * constant[c]);
  return lights;
}

std::vector<float> choose_steps(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights,
                                std::span<const PilotRow> rows, double error) {
  const std::vector<double> spread = spread_of_columns(basis, lights);
  std::vector<double> largest(basis.columns(), 0.0);
  for (const PilotRow& row : rows)
    for (std::size_t c = 0; c < largest.size(); ++c)
      largest[c] = std::max(largest[c], std::fabs(static_cast<double>(row.values[c])));
  const auto steps_at = [&](double scale) {
    std::vector<float> steps;
    for (std::size_t c = 0; c < spread.size(); ++c)
      steps.push_back(static_cast<float>(std::max({scale / spread[c], largest[c] / most_levels, 1e-30})));
    return steps;
  };
  double high = 1e-30;  // a scale at which everything is rounded away
  for (std::size_t c = 0; c < spread.size(); ++c) high = std::max(high, 4.0 * largest[c] * spread[c]);
  double low = high * 1e-8;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    (added_error(rows, lights, steps_at(middle)) > error ? high : low) = middle;
  }
  return steps_at(low);
}

}  // namespace gibench::spectral
