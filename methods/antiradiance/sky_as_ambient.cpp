#include "methods/antiradiance/sky_as_ambient.h"

#include <algorithm>
#include <cmath>

#include "common/core/overloaded.h"
#include "common/scene/light_kinds.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t samples_a_call = std::size_t{1} << 18, fewest_samples = 16, most_samples = 1024;
constexpr int fewest_rows = 256;  // that the sphere is looked at in

Lighting without_environments(Lighting lighting) {
  std::erase_if(lighting.lights, [](const Light& light) { return kind_of(light).background; });
  return lighting;
}

/// Turns about +y: positive angles carry −z towards −x.
Vec3 turned(const Vec3& v, float angle) {
  const float c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

/// Calls body(row, column, unit direction, solid angle) for every pixel, several times where pixels are large.
template <class Body>
void for_pixels(const EnvironmentImage& image, const Body& body) {
  const int finer = (fewest_rows + image.height - 1) / image.height;
  const int rows = finer * image.height, columns = finer * image.width;
  for (int row = 0; row < rows; ++row) {
    const double top = pi_double * row / rows, bottom = pi_double * (row + 1) / rows, polar = 0.5 * (top + bottom);
    const double solid_angle = (std::cos(top) - std::cos(bottom)) * 2.0 * pi_double / columns;
    for (int column = 0; column < columns; ++column) {
      const double around = 2.0 * pi_double * ((column + 0.5) / columns - 0.5);
      const Vec3d direction(std::sin(polar) * std::sin(around), std::cos(polar), -std::sin(polar) * std::cos(around));
      body(row / finer, column / finer, Vec3(direction), solid_angle);
    }
  }
}

/// Adds the means over the sectors.
void add(const EnvironmentLight& light, const DirectionBins* sectors, std::vector<Rgb>& sky) {
  if (!light.image) {
    for (Rgb& radiance : sky) radiance += light.radiance;
    return;
  }
  const EnvironmentImage& image = *light.image;
  const float angle = light.rotate_y_degrees * pi / 180.0F;
  std::vector<RgbDouble> sums(sky.size());
  std::vector<double> weights(sky.size(), 0.0);
  for_pixels(image, [&](int row, int column, const Vec3& direction, double solid_angle) {
    const std::size_t s = sectors != nullptr ? sectors->bin_of(turned(direction, angle)) : 0;
    const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column);
    sums[s] += RgbDouble(image.pixels[pixel]) * solid_angle;
    weights[s] += solid_angle;
  });
  for (std::size_t s = 0; s < sky.size(); ++s)
    if (weights[s] > 0.0) sky[s] += Rgb(sums[s] / weights[s]) * light.radiance;
}

}  // namespace

std::vector<Rgb> sky_by_sector(const std::vector<Light>& lights, const DirectionBins* sectors) {
  std::vector<Rgb> sky(sectors != nullptr ? sectors->count() : 1);
  for (const Light& light : lights)
    std::visit(Overloaded{[&](const EnvironmentLight& environment) { add(environment, sectors, sky); }, [](const PointLight&) {},
                          [](const SpotLight&) {}, [](const DirectionalLight&) {}},
               light);
  return sky;
}

SkyAsAmbient::SkyAsAmbient(const World& world, const Lighting& lighting, const DirectLightOptions& options,
                           const DirectionBins* sectors)
    : world_(world), others_(world, without_environments(lighting), options), sky_(sky_by_sector(lighting.lights, sectors)) {
  has_sky_ = std::any_of(sky_.begin(), sky_.end(), [](const Rgb& radiance) { return !is_black(radiance); });
}

/// Irradiance of the sky, W/m²: what is open, coloured as the open parts of the sectors are.
Rgb SkyAsAmbient::ambient(const SurfaceSample& sample, const Accessibility& accessibility) const {
  if (!sample.lit_side || !has_sky_) return {};
  const Vec3 origin = world_.ray_origin(sample);
  if (sky_.size() == 1) return sky_[0] * (pi * accessibility.at(origin, sample.normal));
  std::vector<float> open(sky_.size());
  const float whole = accessibility.at(origin, sample.normal, no_element, open);
  Rgb sum;
  float shares = 0.0F;
  for (std::size_t s = 0; s < sky_.size(); ++s) sum += sky_[s] * open[s], shares += open[s];
  return shares > 0.0F ? sum * (pi * whole / shares) : Rgb();
}

Rgb SkyAsAmbient::answer(const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t key, std::size_t of_samples,
                         const Accessibility& accessibility, RayStream& rays) const {
  const int samples =
      static_cast<int>(std::clamp(samples_a_call / std::max<std::size_t>(1, of_samples), fewest_samples, most_samples));
  const Rgb from_sky = ambient(sample, accessibility);
  if (toward_viewer == nullptr) return others_.irradiance(sample, key, samples, rays) + from_sky;
  return others_.radiance(sample, *toward_viewer, key, samples, rays) +
         from_sky * world_.scene().material_of_object(sample.object).diffuse / pi;
}

}  // namespace gibench::antiradiance
