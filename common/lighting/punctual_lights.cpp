#include "common/lighting/punctual_lights.h"

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

double mean(const Rgb& c) { return (static_cast<double>(c.r) + static_cast<double>(c.g) + static_cast<double>(c.b)) / 3.0; }

/// Towards a position; `radiance` becomes 1/d², for the intensity to be multiplied in.
LightSample way_to_position(const Vec3& position, const Vec3& from) {
  LightSample sample;
  sample.delta = true;
  const Vec3 way = position - from;
  const float squared = glm::dot(way, way);
  if (!(squared > 0.0F)) return sample;
  sample.direction = way / std::sqrt(squared);
  sample.target = position;
  sample.radiance = Rgb(1.0F / squared);
  sample.pdf = 1.0F;
  return sample;
}

struct PowerOf {
  double scene_radius;

  double operator()(const PointLight& light) const { return 4.0 * pi_double * mean(light.intensity); }
  double operator()(const SpotLight& light) const {
    const double mean_cosine = 0.5 * (static_cast<double>(light.cos_inner) + static_cast<double>(light.cos_outer));
    return 2.0 * pi_double * (1.0 - mean_cosine) * mean(light.intensity);
  }
  double operator()(const DirectionalLight& light) const {
    return pi_double * scene_radius * scene_radius * mean(light.irradiance);
  }
};

/// A spot's cone is taken for a cosine about its axis, whatever its width.
struct PlaceOf {
  std::optional<PlacedLight> operator()(const PointLight& light) const {
    return PlacedLight{light.position, 0.0F, Vec3(0.0F), static_cast<float>(mean(light.intensity))};
  }
  std::optional<PlacedLight> operator()(const SpotLight& light) const {
    return PlacedLight{light.position, 0.0F, static_cast<float>(mean(light.intensity)) * light.direction, 0.0F};
  }
  std::optional<PlacedLight> operator()(const DirectionalLight&) const { return std::nullopt; }
};

}  // namespace

LightSample way_to(const PointLight& light, const Vec3& from) {
  LightSample sample = way_to_position(light.position, from);
  sample.radiance *= light.intensity;
  return sample;
}

LightSample way_to(const SpotLight& light, const Vec3& from) {
  LightSample sample = way_to_position(light.position, from);
  sample.radiance *= spot_intensity(light, -sample.direction);
  return sample;
}

LightSample way_to(const DirectionalLight& light, const Vec3&) {
  LightSample sample;
  sample.delta = sample.at_infinity = true;
  sample.direction = -light.direction;
  sample.radiance = light.irradiance;
  sample.pdf = 1.0F;
  return sample;
}

double power_of(const PunctualLight& light, double scene_radius) { return std::visit(PowerOf{scene_radius}, light); }

std::optional<PlacedLight> place_of(const PunctualLight& light) { return std::visit(PlaceOf(), light); }

Rgb spot_intensity(const SpotLight& light, const Vec3& leaving) {
  const float cosine = glm::dot(light.direction, leaving);
  if (cosine >= light.cos_inner) return light.intensity;
  if (cosine <= light.cos_outer) return Rgb();
  const float x = (cosine - light.cos_outer) / (light.cos_inner - light.cos_outer);
  return light.intensity * (x * x * (3.0F - 2.0F * x));
}

}  // namespace gibench
