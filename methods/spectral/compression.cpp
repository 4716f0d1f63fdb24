#include "methods/spectral/compression.h"

#include <algorithm>
#include <cmath>

#include "common/core/random.h"
#include "common/core/sampling.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t light_stage = 0x747269616cULL;
constexpr std::size_t light_triples = 4;
constexpr std::size_t slot_chunk = 512;
constexpr int halvings = 40;
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

float irradiance_from(const Vec3& light, const World& world, const SurfaceSample& sample, float nearest, RayStream& rays) {
  const Vec3 origin = world.ray_origin(sample), toward = light - origin;
  const float squared = std::max(glm::dot(toward, toward), nearest * nearest);
  const float cosine = glm::dot(toward, sample.normal) / std::sqrt(squared);
  if (!(cosine > 0.0F) || rays.occluded({origin, 0.0F, toward, 1.0F})) return 0.0F;
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
    for (std::uint32_t order = 0; order < part.width; ++order)
      spread[part.column + order] = std::max({squares[order], least_spread * largest, 1e-30}) * std::sqrt(part_weight[p]);
  }
  return spread;
}

/// Squares of the rows' answers, and what rounding adds to those of their errors.
struct Energy {
  double whole = 0.0, added = 0.0;
};

RgbDouble answer_to(const std::vector<Rgb4>& light, std::span<const float> row) {
  RgbDouble sum;
  for (std::size_t c = 0; c < row.size(); ++c) sum += RgbDouble(Rgb(light[c])) * static_cast<double>(row[c]);
  return sum;
}

Energy energy_of(std::span<const PilotRow> rows, const std::vector<std::vector<Rgb4>>& lights, std::span<const float> steps) {
  Energy energy;
  std::vector<float> change(steps.size());
  for (const PilotRow& row : rows) {
    for (std::size_t c = 0; c < steps.size(); ++c)
      change[c] = std::nearbyint(row.values[c] / steps[c]) * steps[c] - row.values[c];
    for (const auto& light : lights) {
      const RgbDouble whole = answer_to(light, row.values), off = answer_to(light, change);
      // (x − A)(x − B) of the rounded answer less that of the answer itself.
      RgbDouble doubted = off;
      for (const std::vector<float>& other : row.others)
        if (!other.empty()) doubted += whole - answer_to(light, other);
      const RgbDouble added = off * doubted, squared = whole * whole;
      energy.whole += row.area * (squared.r + squared.g + squared.b);
      energy.added += row.area * (added.r + added.g + added.b);
    }
  }
  return energy;
}

}  // namespace

std::vector<std::vector<Rgb4>> trial_lights(const World& world, const SamplingMesh& mesh, const SpectralBasis& basis,
                                            std::span<const std::uint32_t> vertex_of_slot, Task& task) {
  std::vector<std::vector<Rgb4>> lights;
  std::vector<double> area;
  for (const std::uint32_t vertex : vertex_of_slot) area.push_back(static_cast<double>(mesh.vertices()[vertex].area));
  std::vector<Rgb4> field(basis.slots());
  for (std::size_t triple = 0; triple < light_triples; ++triple) {
    std::array<Vec3, 3> places;
    {
      RayStream rays = task.rays(world);
      for (std::size_t i = 0; i < 3; ++i) places[i] = place_of_light(world, mesh, 3 * triple + i, rays, task.seed());
    }
    task.parallel_chunks(field.size(), slot_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world);
      for (std::size_t slot = range.begin; slot < range.end; ++slot) {
        const std::uint32_t vertex = vertex_of_slot[slot];
        const SurfaceSample sample = mesh.sample(world, vertex, mesh.sites(vertex).front());
        const float nearest = std::sqrt(mesh.vertices()[vertex].area);
        const auto from = [&](std::size_t i) { return irradiance_from(places[i], world, sample, nearest, rays); };
        field[slot] = Rgb(from(0), from(1), from(2));
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
  double low = high * 1e-12;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    const Energy energy = energy_of(rows, lights, steps_at(middle));
    (energy.added > error * error * energy.whole ? high : low) = middle;
  }
  return steps_at(low);
}

}  // namespace gibench::spectral
