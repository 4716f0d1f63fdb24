/// Next-event estimation: the weights of a sampled light and of a light that a ray hits by chance.
#pragma once

#include <cmath>
#include <cstdint>

#include "common/lighting/light_sample.h"
#include "common/lighting/mis.h"
#include "common/lighting/scene_lights.h"

namespace gibench {

/// An emitting surface that a ray met.
struct MetEmitter {
  std::uint32_t triangle, material;
  float distance;  ///< metres, from where the ray left
  float cosine;    ///< of the ray's way back and the normal of the triangle's front
  bool two_sided;
};

/// `samples` samples of each group of lights at a surface point beside one ray drawn from its lobe, by the power heuristic.
/// Densities in 1/sr.
class NextEvent {
 public:
  NextEvent(const SceneLights& lights, float samples) : lights_(lights), samples_(samples) {}

  /// Density of all light samples together at the direction of one of them.
  float density(const LightSample& light) const { return samples_ * light.pdf; }
  /// Of a light sample in whose direction the lobe would have been drawn with density `lobe_pdf`.
  float weight(const LightSample& light, float lobe_pdf) const {
    return light.delta ? 1.0F : power_heuristic(density(light), lobe_pdf);
  }

  /// Radiance of what a ray from a surface point with this normal met, times its weight; `lobe_pdf`: with which the ray was
  /// drawn, 0: a mirror's.
  Rgb emission(const Vec3& position, const Vec3& normal, const MetEmitter& met, float lobe_pdf) const {
    const Rgb& radiance = lights_.emission_of_material(met.material);
    if (is_black(radiance)) return Rgb();
    if (met.cosine < 0.0F && !met.two_sided) return Rgb();
    if (!(lobe_pdf > 0.0F)) return radiance;
    const float found = lights_.pdf_of_triangle(position, normal, met.triangle, met.distance, std::fabs(met.cosine));
    return radiance * power_heuristic(lobe_pdf, samples_ * found);
  }
  /// The same of a ray that left the scene from a surface with this normal.
  Rgb environment(const Vec3& normal, const Vec3& direction, float lobe_pdf) const {
    const Rgb radiance = lights_.environment(direction);
    if (!(lobe_pdf > 0.0F) || is_black(radiance)) return radiance;
    return radiance * power_heuristic(lobe_pdf, samples_ * lights_.pdf_of_environment(normal, direction));
  }

 private:
  const SceneLights& lights_;
  float samples_;
};

}  // namespace gibench
