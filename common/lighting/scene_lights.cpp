#include "common/lighting/scene_lights.h"

#include <algorithm>

#include "common/core/overloaded.h"

namespace gibench {

namespace {

constexpr std::uint32_t no_emitter = 0xffffffffU;

}  // namespace

SceneLights::SceneLights(const World& world, const Lighting& lighting, PunctualLights punctual) : emission_(lighting.emission) {
  add_emitters(world);
  add_lights(world, lighting.lights, punctual);
  choice_ = LightChoice(power_, source_);
  power_ = {};
  source_ = {};
}

void SceneLights::add_emitters(const World& world) {
  const Scene& scene = world.scene();
  std::uint32_t source = 0;
  for (const Object& object : scene.objects) {
    const Rgb& radiance = emission_[object.material];
    if (is_black(radiance)) continue;
    if (emitter_of_triangle_.empty()) emitter_of_triangle_.assign(scene.triangles.size(), no_emitter);
    for (std::uint32_t triangle = object.triangle_begin; triangle < object.triangle_end; ++triangle) {
      if (!(world.area(triangle) > 0.0F)) continue;
      emitter_of_triangle_[triangle] = static_cast<std::uint32_t>(emitters_.size());
      emitters_.emplace_back(world, triangle, object.two_sided, radiance);
      power_.push_back(emitters_.back().power());
      source_.push_back(source);
    }
    ++source;
  }
}

void SceneLights::add_lights(const World& world, const std::vector<Light>& lights, PunctualLights punctual) {
  const double radius = 0.5 * static_cast<double>(world.diagonal());
  std::uint32_t source = source_.empty() ? 0 : source_.back() + 1;
  const auto add = [&](double power) {
    power_.push_back(power);
    source_.push_back(source++);
  };
  const auto add_punctual = [&](const PunctualLight& light) {
    const double power = power_of(light, radius);
    if (!(power > 0.0)) return;
    punctual_.push_back(light);
    add(punctual == PunctualLights::sampled ? power : 0.0);
  };
  std::vector<const EnvironmentLight*> environments;
  const Overloaded sort{add_punctual, [&](const EnvironmentLight& light) { environments.push_back(&light); }};
  for (const Light& light : lights) std::visit(sort, light);
  for (const EnvironmentLight* environment : environments) {
    EnvironmentSampler sampler(*environment);
    if (!(sampler.integral() > 0.0)) continue;
    add(sampler.integral() * pi_double * radius * radius);
    environments_.push_back(std::move(sampler));
  }
}

Hit SceneLights::emitter_met(const Vec3& origin, const Vec3& direction) const {
  Hit nearest;
  for (const TriangleEmitter& emitter : emitters_)
    if (const Hit hit = emitter.met_by(origin, direction); hit && (!nearest || hit.distance < nearest.distance)) nearest = hit;
  return nearest;
}

Rgb SceneLights::environment(const Vec3& direction) const {
  Rgb sum;
  for (const EnvironmentSampler& environment : environments_) sum += environment.radiance(direction);
  return sum;
}

LightSample SceneLights::punctual(std::size_t light, const Vec3& position) const {
  return std::visit([&](const auto& one) { return way_to(one, position); }, punctual_[light]);
}

LightSample SceneLights::sample(const Vec3& position, const Vec3& normal, std::uint32_t choice, Vec2 u) const {
  std::size_t light = choice_.choose(choice);
  const float probability = choice_.probability(light);
  LightSample sample;
  if (light < emitters_.size()) {
    sample = emitters_[light].sample(position, u);
  } else if (light -= emitters_.size(); light < punctual_.size()) {
    sample = punctual(light, position);
  } else {
    return sample_environment(environments_[light - punctual_.size()], normal, u);
  }
  sample.pdf *= probability;
  return sample;
}

/// All environments lie in every direction: the radiance and the density are those of all of them.
LightSample SceneLights::sample_environment(const EnvironmentSampler& chosen, const Vec3& normal, Vec2 u) const {
  LightSample sample;
  sample.at_infinity = true;
  sample.direction = chosen.sample(normal, u);
  sample.radiance = environment(sample.direction);
  sample.pdf = pdf_of_environment(normal, sample.direction);
  return sample;
}

float SceneLights::pdf_of_triangle(const Vec3& position, std::uint32_t triangle, float distance, float cosine) const {
  const std::uint32_t emitter = emitter_of_triangle_[triangle];
  if (emitter == no_emitter) return 0.0F;
  return choice_.probability(emitter) * emitters_[emitter].pdf(position, distance, cosine);
}

float SceneLights::pdf_of_environment(const Vec3& normal, const Vec3& direction) const {
  float pdf = 0.0F;
  for (std::size_t i = 0; i < environments_.size(); ++i)
    pdf += choice_.probability(emitters_.size() + punctual_.size() + i) * environments_[i].pdf(normal, direction);
  return pdf;
}

std::size_t SceneLights::bytes() const {
  return emitters_.capacity() * (sizeof(TriangleEmitter) + sizeof(double) + sizeof(float) + sizeof(std::uint32_t)) +
         emitter_of_triangle_.capacity() * sizeof(std::uint32_t);
}

}  // namespace gibench
