#include "common/lighting/light_sampler.h"

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

/// Share of a spot's intensity in a direction: 1 inside the inner cone, smoothstep in the cosine to the outer one.
float spot_falloff(const SpotLight& spot, float cosine) {
  if (cosine <= spot.cos_outer) return 0.0F;
  if (cosine >= spot.cos_inner) return 1.0F;
  const float t = (cosine - spot.cos_outer) / (spot.cos_inner - spot.cos_outer);
  return t * t * (3.0F - 2.0F * t);
}

/// Power of a punctual light, W; `disc` is the scene's cross-section, m².
double punctual_power(const Light& light, double disc) {
  if (const auto* point = std::get_if<PointLight>(&light))
    return 4.0 * pi_double * static_cast<double>(largest(point->intensity));
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return disc * static_cast<double>(largest(sun->irradiance));
  const auto& spot = std::get<SpotLight>(light);
  const double mean_cosine = 0.5 * static_cast<double>(spot.cos_inner + spot.cos_outer);
  return 2.0 * pi_double * std::max(1e-6, 1.0 - mean_cosine) * static_cast<double>(largest(spot.intensity));
}

}  // namespace

LightSampler::LightSampler(const World& world, const Lighting& lighting)
    : world_(world), lights_(lighting.lights), emission_(lighting.emission) {
  std::vector<double> power = add_triangles();
  add_lights(power);
  tabulate(power);
}

std::vector<double> LightSampler::add_triangles() {
  const Scene& scene = world_.scene();
  const auto count = static_cast<std::uint32_t>(scene.triangles.size());
  material_of_triangle_.resize(count);
  area_density_.assign(count, 0.0F);
  std::vector<double> power;
  for (std::uint32_t t = 0; t < count; ++t) {
    const Object& object = scene.objects[scene.triangle_object[t]];
    material_of_triangle_[t] = object.material;
    const Rgb radiance = emission_[object.material];
    if (is_black(radiance) || !(world_.area(t) > 0.0F)) continue;
    sources_.push_back({Kind::triangle, t});
    const double sides = object.two_sided ? 2.0 : 1.0;
    power.push_back(sides * pi_double * static_cast<double>(world_.area(t)) * static_cast<double>(largest(radiance)));
  }
  return power;
}

void LightSampler::add_lights(std::vector<double>& power) {
  const double radius = 0.5 * static_cast<double>(world_.diagonal());
  const double disc = pi_double * radius * radius;
  for (std::uint32_t i = 0; i < lights_.size(); ++i) {
    if (const auto* sky = std::get_if<EnvironmentLight>(&lights_[i])) {
      sources_.push_back({Kind::environment, static_cast<std::uint32_t>(environments_.size())});
      environments_.emplace_back(*sky);
      power.push_back(disc * environments_.back().integral());
    } else {
      delta_.push_back(static_cast<std::uint32_t>(sources_.size()));
      sources_.push_back({Kind::punctual, i});
      power.push_back(punctual_power(lights_[i], disc));
    }
  }
}

void LightSampler::tabulate(const std::vector<double>& power) {
  choice_ = AliasTable(power);
  if (choice_.empty()) return;
  std::vector<double> extended = power;
  for (const std::uint32_t light : delta_) extended[light] = 0.0;
  extended_choice_ = AliasTable(extended);
  for (std::uint32_t i = 0; i < sources_.size(); ++i) {
    const float probability = choice_.probability(i);
    if (sources_[i].kind == Kind::environment) environment_probability_.push_back(probability);
    if (sources_[i].kind == Kind::triangle) area_density_[sources_[i].index] = probability / world_.area(sources_[i].index);
    if (!extended_choice_.empty() && extended_choice_.probability(i) > 0.0F)
      extended_factor_ = extended_choice_.probability(i) / probability;
  }
}

Rgb LightSampler::environment(const Vec3& direction) const {
  Rgb sum;
  for (const Environment& environment : environments_) sum += environment.radiance(direction);
  return sum;
}

std::optional<LightSample> LightSampler::sample(const SurfaceSample& from, float u_light, Vec2 u) const {
  return sample_source(from, choice_, u_light, u);
}

std::optional<LightSample> LightSampler::sample_extended(const SurfaceSample& from, float u_light, Vec2 u) const {
  return sample_source(from, extended_choice_, u_light, u);
}

std::optional<LightSample> LightSampler::delta_light(const SurfaceSample& from, std::uint32_t light) const {
  return towards(from, lights_[sources_[light].index], 1.0F);
}

std::optional<LightSample> LightSampler::sample_source(const SurfaceSample& from, const AliasTable& table, float u_light,
                                                       Vec2 u) const {
  if (table.empty()) return std::nullopt;
  const std::uint32_t chosen = table.draw(u_light);
  const float probability = table.probability(chosen);
  if (!(probability > 0.0F)) return std::nullopt;
  const Source& source = sources_[chosen];
  switch (source.kind) {
    case Kind::triangle: return sample_triangle(from, source.index, probability, u);
    case Kind::environment: return sample_environment(from, source.index, probability, u);
    case Kind::punctual: return towards(from, lights_[source.index], probability);
  }
  return std::nullopt;
}

std::optional<LightSample> LightSampler::sample_triangle(const SurfaceSample& from, std::uint32_t triangle, float probability,
                                                         Vec2 u) const {
  const float root = std::sqrt(u.x);
  const Vec2 barycentrics{root * (1.0F - u.y), root * u.y};
  const Vec3 apart = world_.position(triangle, barycentrics) - from.position;
  const SurfaceSample point = world_.sample_at(triangle, barycentrics, -apart);
  const float squared = glm::dot(apart, apart);
  if (!point.lit_side || !(squared > 0.0F)) return std::nullopt;
  LightSample sample;
  sample.direction = apart / std::sqrt(squared);
  const float cosine_light = -glm::dot(point.normal, sample.direction);
  if (!(cosine_light > 0.0F) || !(glm::dot(from.normal, sample.direction) > 0.0F)) return std::nullopt;
  sample.radiance = emission_[material_of_triangle_[triangle]];
  sample.pdf = probability / world_.area(triangle) * squared / cosine_light;
  sample.shadow = world_.segment(from, point);
  return sample;
}

/// A direction drawn from one environment; what comes from there is the light of all of them, and so is the density.
std::optional<LightSample> LightSampler::sample_environment(const SurfaceSample& from, std::uint32_t index, float probability,
                                                            Vec2 u) const {
  LightSample sample;
  sample.direction = environments_[index].sample(u, from.normal);
  if (!(glm::dot(from.normal, sample.direction) > 0.0F)) return std::nullopt;
  sample.radiance = environment(sample.direction);
  sample.pdf = probability / environment_probability_[index] * pdf_of_environment(sample.direction, from.normal);
  if (!(sample.pdf > 0.0F)) return std::nullopt;
  sample.shadow = {world_.ray_origin(from), 0.0F, sample.direction};
  return sample;
}

std::optional<LightSample> LightSampler::towards(const SurfaceSample& from, const Light& light, float probability) const {
  LightSample sample;
  sample.delta = true;
  sample.pdf = probability;
  const Vec3 origin = world_.ray_origin(from);
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    sample.direction = -sun->direction;
    sample.radiance = sun->irradiance;
    sample.shadow = {origin, 0.0F, sample.direction};
  } else {
    const auto* point = std::get_if<PointLight>(&light);
    const auto* spot = std::get_if<SpotLight>(&light);
    const Vec3 position = point != nullptr ? point->position : spot->position;
    const Vec3 apart = position - from.position;
    const float squared = glm::dot(apart, apart);
    if (!(squared > 0.0F)) return std::nullopt;
    sample.direction = apart / std::sqrt(squared);
    const Rgb intensity =
        point != nullptr ? point->intensity : spot->intensity * spot_falloff(*spot, -glm::dot(spot->direction, sample.direction));
    sample.radiance = intensity / squared;
    sample.shadow = {origin, 0.0F, position - origin, 1.0F};
  }
  if (!(glm::dot(from.normal, sample.direction) > 0.0F) || is_black(sample.radiance)) return std::nullopt;
  return sample;
}

float LightSampler::pdf_of_hit(const Vec3& from, const SurfaceSample& hit) const {
  const float density = area_density_[hit.triangle];
  if (!(density > 0.0F)) return 0.0F;
  const Vec3 apart = hit.position - from;
  const float squared = glm::dot(apart, apart);
  const float projected = -glm::dot(hit.normal, apart);  // cosine at the light times the distance
  return projected > 0.0F ? density * squared * std::sqrt(squared) / projected : 0.0F;
}

float LightSampler::pdf_of_environment(const Vec3& direction, const Vec3& normal) const {
  float sum = 0.0F;
  for (std::size_t i = 0; i < environments_.size(); ++i)
    sum += environment_probability_[i] * environments_[i].pdf(direction, normal);
  return sum;
}

}  // namespace gibench
