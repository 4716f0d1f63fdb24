#include "common/lighting/scene_lights.h"

#include <algorithm>

#include "common/core/overloaded.h"

namespace gibench {

namespace {

constexpr std::uint32_t no_emitter = 0xffffffffU;

/// Irradiance on a surface with this normal, averaged over the channels, where nothing lies between; zero from behind.
double irradiance_on(const Vec3& normal, const LightSample& light) {
  const double mean =
      (static_cast<double>(light.radiance.r) + static_cast<double>(light.radiance.g) + static_cast<double>(light.radiance.b)) /
      3.0;
  return std::max(0.0, static_cast<double>(glm::dot(normal, light.direction))) * mean;
}

/// In [0, 1), of a fraction that rounding may have made 1.
float unit_float(double fraction) { return std::min(static_cast<float>(fraction), 0x1.fffffep-1F); }

/// By power and evenly over the sources where there is something to choose.
LightChoice choice_of(const std::vector<double>& power, const std::vector<std::uint32_t>& source) {
  return power.size() > 1 ? LightChoice(power, source) : LightChoice({}, {});
}

}  // namespace

SceneLights::SceneLights(const World& world, const Lighting& lighting, PunctualLights punctual) : emission_(lighting.emission) {
  Placed placed;
  add_emitters(world, placed);
  add_punctual(world, lighting.lights, punctual, placed);
  add_environments(lighting.lights);
  placed_by_power_ = choice_of(placed.power, placed.source);
  if (placed.lights.size() > 1) placed_by_estimate_ = LightTree(placed.lights);
  add_group(LightGroup::placed, placed.lights.size());
  add_group(LightGroup::directional, directional_.size());
  add_group(LightGroup::environment, environments_.size());
}

void SceneLights::add_group(LightGroup group, std::size_t lights) {
  if (lights > 0) groups_.push_back(group);
  has_choice_[static_cast<std::size_t>(group)] = lights > 1;
}

void SceneLights::add_emitters(const World& world, Placed& placed) {
  const Scene& scene = world.scene();
  for (const Object& object : scene.objects) {
    const Rgb& radiance = emission_[object.material];
    if (is_black(radiance)) continue;
    if (emitter_of_triangle_.empty()) emitter_of_triangle_.assign(scene.triangles.size(), no_emitter);
    for (std::uint32_t triangle = object.triangle_begin; triangle < object.triangle_end; ++triangle) {
      if (!(world.area(triangle) > 0.0F)) continue;
      emitter_of_triangle_[triangle] = static_cast<std::uint32_t>(emitters_.size());
      emitters_.emplace_back(world, triangle, object.two_sided, radiance);
      placed.add(emitters_.back().as_placed(), emitters_.back().power(), placed.sources);
    }
    ++placed.sources;
  }
}

/// Those that shall be sampled are numbered after the emitters, or are directional.
void SceneLights::add_punctual(const World& world, const std::vector<Light>& lights, PunctualLights punctual, Placed& placed) {
  const double radius = 0.5 * static_cast<double>(world.diagonal());
  const auto add = [&](const PunctualLight& light) {
    const double power = power_of(light, radius);
    if (!(power > 0.0)) return;
    const auto index = static_cast<std::uint32_t>(punctual_.size());
    punctual_.push_back(light);
    if (punctual == PunctualLights::visited) return;
    if (const auto place = place_of(light)) {
      placed_punctual_.push_back(index);
      placed.add(*place, power, placed.sources++);
    } else {
      directional_.push_back(index);
    }
  };
  for (const Light& light : lights) std::visit(Overloaded{add, [](const EnvironmentLight&) {}}, light);
}

void SceneLights::add_environments(const std::vector<Light>& lights) {
  std::vector<double> power;
  std::vector<std::uint32_t> source;
  const auto add = [&](const EnvironmentLight& light) {
    EnvironmentSampler sampler(light);
    if (!(sampler.integral() > 0.0)) return;
    power.push_back(sampler.integral());
    source.push_back(static_cast<std::uint32_t>(source.size()));
    environments_.push_back(std::move(sampler));
  };
  for (const Light& light : lights) std::visit(Overloaded{add, [](const PunctualLight&) {}}, light);
  environment_by_power_ = choice_of(power, source);
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

LightSample SceneLights::sample(LightGroup group, const Vec3& position, const Vec3& normal, std::uint32_t choice, Vec2 u) const {
  switch (group) {
    case LightGroup::placed: return sample_placed(choose_placed(position, normal, choice), position, u);
    case LightGroup::directional: return sample_directional(position, normal, choice);
    case LightGroup::environment:
      return sample_environment(environment_by_power_.empty() ? 0 : environment_by_power_.choose(choice), normal, u);
  }
  return {};
}

LightSample SceneLights::sample(LightGroup group, const Vec3& position, const Vec3& normal, SobolPair pair) const {
  const Vec2 u = pair.unit();
  switch (group) {
    case LightGroup::placed: {
      if (placed_by_power_.empty()) return sample_placed({0, 1.0F}, position, u);
      const LightTree::Choice chosen = choose_placed(position, normal, pair.x);
      return sample_placed(chosen, position, {unit_float(chosen.rest), u.y});
    }
    case LightGroup::directional: return sample_directional(position, normal, pair.x);
    case LightGroup::environment: {
      if (environment_by_power_.empty()) return sample_environment(0, normal, u);
      const std::size_t chosen = environment_by_power_.choose(pair.x);
      return sample_environment(chosen, normal, {unit_float(environment_by_power_.rest(chosen, pair.x)), u.y});
    }
  }
  return {};
}

/// Probability 0: no light.
LightTree::Choice SceneLights::choose_placed(const Vec3& position, const Vec3& normal, std::uint32_t choice) const {
  LightTree::Choice chosen{0, 1.0F};
  if (placed_by_power_.empty()) return chosen;
  const std::uint32_t rest = choice << 1U;  // the first bit picks between the two ways to choose
  if (choice == rest >> 1U) {
    chosen.light = placed_by_power_.choose(rest);
    chosen.rest = placed_by_power_.rest(chosen.light, rest);
    chosen.probability = placed_by_estimate_.probability(chosen.light, position, normal);
  } else {
    chosen = placed_by_estimate_.choose(position, normal, static_cast<double>(rest) * 0x1p-32);
    if (!(chosen.probability > 0.0F)) return {};
  }
  chosen.probability = 0.5F * (placed_by_power_.probability(chosen.light) + chosen.probability);
  return chosen;
}

LightSample SceneLights::sample_placed(const LightTree::Choice& chosen, const Vec3& position, Vec2 u) const {
  if (!(chosen.probability > 0.0F)) return {};
  LightSample sample = chosen.light < emitters_.size() ? emitters_[chosen.light].sample(position, u)
                                                       : punctual(placed_punctual_[chosen.light - emitters_.size()], position);
  sample.pdf *= chosen.probability;
  return sample;
}

LightSample SceneLights::sample_directional(const Vec3& position, const Vec3& normal, std::uint32_t choice) const {
  if (directional_.size() == 1) return punctual(directional_.front(), position);
  double total = 0.0, facing = 0.0;
  for (const std::uint32_t light : directional_) {
    const double irradiance = irradiance_on(normal, punctual(light, position));
    total += irradiance;
    facing += irradiance > 0.0 ? 1.0 : 0.0;
  }
  LightSample sample;
  double left = static_cast<double>(choice) * 0x1p-32;
  for (const std::uint32_t light : directional_) {
    const LightSample way = punctual(light, position);
    const double irradiance = irradiance_on(normal, way);
    if (!(irradiance > 0.0)) continue;
    const double probability = 0.5 * irradiance / total + 0.5 / facing;
    sample = way;  // the last one where rounding leaves a rest
    sample.pdf = static_cast<float>(probability);
    if (left < probability) break;
    left -= probability;
  }
  return sample;
}

/// All environments lie in every direction: the radiance and the density are those of all of them.
LightSample SceneLights::sample_environment(std::size_t chosen, const Vec3& normal, Vec2 u) const {
  LightSample sample;
  sample.at_infinity = true;
  sample.direction = environments_[chosen].sample(normal, u);
  sample.radiance = environment(sample.direction);
  sample.pdf = pdf_of_environment(normal, sample.direction);
  return sample;
}

float SceneLights::pdf_of_triangle(const Vec3& position, const Vec3& normal, std::uint32_t triangle, float distance,
                                   float cosine) const {
  const std::uint32_t emitter = emitter_of_triangle_[triangle];
  if (emitter == no_emitter) return 0.0F;
  const float pdf = emitters_[emitter].pdf(position, distance, cosine);
  if (placed_by_power_.empty()) return pdf;
  return 0.5F * (placed_by_power_.probability(emitter) + placed_by_estimate_.probability(emitter, position, normal)) * pdf;
}

float SceneLights::pdf_of_environment(const Vec3& normal, const Vec3& direction) const {
  if (environment_by_power_.empty()) return environments_.empty() ? 0.0F : environments_.front().pdf(normal, direction);
  float pdf = 0.0F;
  for (std::size_t i = 0; i < environments_.size(); ++i)
    pdf += environment_by_power_.probability(i) * environments_[i].pdf(normal, direction);
  return pdf;
}

std::size_t SceneLights::bytes() const {
  return emitters_.capacity() * (sizeof(TriangleEmitter) + sizeof(double) + sizeof(float) + sizeof(std::uint32_t)) +
         emitter_of_triangle_.capacity() * sizeof(std::uint32_t) + placed_by_estimate_.bytes();
}

}  // namespace gibench
