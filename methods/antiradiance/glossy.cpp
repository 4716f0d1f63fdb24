#include "methods/antiradiance/glossy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/material_kinds.h"

namespace gibench::antiradiance {

namespace {

/// Radians to where a lobe has fallen to a half; π for none.
float lobe_radius(const Material& material) {
  switch (material.bsdf) {
    case Bsdf::diffuse: return pi;
    case Bsdf::phong:  // cosⁿ θ = 1/2
      return !is_black(material.specular) && material.exponent > 0.0F ? std::acos(std::pow(0.5F, 1.0F / material.exponent)) : pi;
    case Bsdf::ggx:  // about tan θ = 1.3 α about the reflected direction
      return std::atan(1.3F * material.roughness * material.roughness);
    case Bsdf::mirror: return is_black(material.reflectance) ? pi : 0.0F;
  }
  return 0.0F;
}

/// The most that the part which is not diffuse reflects from one direction, channel by channel.
Rgb most_reflected(const Material& material) {
  switch (material.bsdf) {
    case Bsdf::diffuse: return {};
    case Bsdf::phong: return material.specular;
    case Bsdf::ggx: return grazing_reflectance(material);
    case Bsdf::mirror: return material.reflectance;
  }
  return Rgb(1.0F);
}

}  // namespace

std::string too_narrow_for_bins(const Material& material, int bins) {
  if (gloss_of(material) == Gloss::mirror)
    return fmt::format("material '{}' is a mirror, whose reflections no directional bin can hold", material.name);
  const float bin_radius = 2.0F / static_cast<float>(bins);  // radians, of a cap with a bin's solid angle
  const float radius = lobe_radius(material);
  if (radius >= 0.5F * bin_radius) return {};
  return fmt::format(
      "the lobe of material '{}' (half-width {:.1f} degrees) is narrower than half a directional bin: raise the parameter bins",
      material.name, radius * 180.0F / pi);
}

GlossyReflection::GlossyReflection(const Scene& scene, std::span<const std::uint32_t> leaf_materials, const DirectionBins& bins)
    : bins_(bins), bsdf_of_material_(scene.materials.size(), -1) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (gloss_of(scene.materials[i]) != Gloss::lobe) continue;
    bsdf_of_material_[i] = static_cast<int>(bsdfs_.size());
    bsdfs_.push_back(SurfaceBsdf::specular_part(scene.materials[i]));
    most_reflected_.push_back(most_reflected(scene.materials[i]));
  }
  for (const std::uint32_t material : leaf_materials) bsdf_of_leaf_.push_back(bsdf_of_material_[material]);
}

Rgb GlossyReflection::lobe(std::size_t bsdf, const Vec3& out, const Vec3& in) const {
  return bsdfs_[bsdf].evaluate(out, in).value;
}

void GlossyReflection::reflect(std::size_t leaf, const Vec3& normal, std::span<const float> projected, const float* arriving,
                               float* exitant) const {
  const auto bsdf = static_cast<std::size_t>(bsdf_of_leaf_[leaf]);
  const Frame frame(normal);
  const std::size_t count = bins_.count();
  std::vector<Vec3> local(count);
  for (std::size_t b = 0; b < count; ++b) local[b] = frame.to_local(bins_.direction(b));
  std::vector<Rgb> values(count);
  for (std::size_t in = 0; in < count; ++in) {
    const float* light = arriving + 4 * in;
    if (projected[in] > 0.0F || (light[0] == 0.0F && light[1] == 0.0F && light[2] == 0.0F)) continue;
    Rgb sum;
    for (std::size_t out = 0; out < count; ++out) {
      if (!(projected[out] > 0.0F)) continue;
      values[out] = lobe(bsdf, local[out], -local[in]);
      sum += values[out] * projected[out];
    }
    for (int c = 0; c < 3; ++c) {
      const float scale = sum[c] > most_reflected_[bsdf][c] ? most_reflected_[bsdf][c] / sum[c] : 1.0F;
      for (std::size_t out = 0; out < count; ++out)
        if (projected[out] > 0.0F) exitant[4 * out + static_cast<std::size_t>(c)] += values[out][c] * scale * light[c];
    }
  }
}

Rgb GlossyReflection::radiance(std::uint32_t material, const Vec3& normal, const Vec3& toward_viewer,
                               std::span<const float> projected, const float* arriving) const {
  const int bsdf = bsdf_of_material_[material];
  if (bsdf < 0) return {};
  const Frame frame(normal);
  const Vec3 out = frame.to_local(toward_viewer);
  Rgb sum;
  for (std::size_t in = 0; in < bins_.count(); ++in) {
    if (projected[in] > 0.0F) continue;
    const float* light = arriving + 4 * in;
    sum += lobe(static_cast<std::size_t>(bsdf), out, -frame.to_local(bins_.direction(in))) * Rgb(light[0], light[1], light[2]);
  }
  return sum;
}

}  // namespace gibench::antiradiance
