#include "methods/antiradiance/sky_as_ambient.h"

#include <algorithm>

#include "common/scene/light_kinds.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t samples_a_call = std::size_t{1} << 18, fewest_samples = 16, most_samples = 1024;

Lighting without_environments(Lighting lighting) {
  std::erase_if(lighting.lights, [](const Light& light) { return kind_of(light).background; });
  return lighting;
}

/// ∫ over the sphere by the pixels' solid angles; constant without an image.
Rgb mean_radiance(const LightParts<const Light>& light) {
  if (light.image == nullptr) return *light.strength;
  RgbDouble sum;
  double weights = 0.0;
  for (int row = 0; row < light.image->height; ++row) {
    const double weight = std::sin(pi_double * (row + 0.5) / light.image->height);
    for (int column = 0; column < light.image->width; ++column) {
      sum += RgbDouble(light.image->pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(light.image->width) +
                                           static_cast<std::size_t>(column)]) *
             weight;
      weights += weight;
    }
  }
  return weights > 0.0 ? Rgb(sum / weights) * *light.strength : Rgb();
}

}  // namespace

SkyAsAmbient::SkyAsAmbient(const World& world, const Lighting& lighting, const DirectLightOptions& options)
    : world_(world), others_(world, without_environments(lighting), options) {
  for (const Light& light : lighting.lights)
    if (kind_of(light).background) radiance_ += mean_radiance(parts_of(light));
}

Rgb SkyAsAmbient::answer(const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t key, std::size_t of_samples,
                         const Accessibility& accessibility, RayStream& rays) const {
  const int samples =
      static_cast<int>(std::clamp(samples_a_call / std::max<std::size_t>(1, of_samples), fewest_samples, most_samples));
  Rgb ambient;
  if (sample.lit_side && !is_black(radiance_))
    ambient = radiance_ * pi * accessibility.at(world_.ray_origin(sample), sample.normal);
  if (toward_viewer == nullptr) return others_.irradiance(sample, key, samples, rays) + ambient;
  return others_.radiance(sample, *toward_viewer, key, samples, rays) +
         ambient * world_.scene().material_of_object(sample.object).diffuse / pi;
}

}  // namespace gibench::antiradiance
