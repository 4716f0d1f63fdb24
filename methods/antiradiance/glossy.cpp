#include "methods/antiradiance/glossy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/material_kinds.h"

namespace gibench::antiradiance {

namespace {

constexpr float most_raised = 2.0F;

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

/// What a sum over bins is to be multiplied by to be what it should, raised by no more than twofold.
float corrected(float sum, float wanted) { return sum > 0.0F ? std::min(most_raised, wanted / sum) : 0.0F; }

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
    bsdf_of_material_[i] = static_cast<int>(lobes_.size());
    const SurfaceBsdf bsdf = SurfaceBsdf::specular_part(scene.materials[i]);
    lobes_.push_back({bsdf, LobeAlbedo(bsdf)});
  }
  for (const std::uint32_t material : leaf_materials) bsdf_of_leaf_.push_back(bsdf_of_material_[material]);
}

void GlossyReflection::reflect(std::size_t leaf, const Vec3& normal, std::span<const float> projected, const float* arriving,
                               float scale, float* exitant) const {
  LeafLobe lobe(*this, leaf, normal, projected);
  for (std::size_t in = 0; in < bins_.count(); ++in) {
    const float* light = arriving + channels * in;
    if (projected[in] > 0.0F || (light[0] == 0.0F && light[1] == 0.0F && light[2] == 0.0F)) continue;
    lobe.reflect(-bins_.direction(in), Rgb(light[0], light[1], light[2]) * scale, exitant);
  }
}

Rgb GlossyReflection::radiance(std::uint32_t material, const Vec3& normal, const Vec3& toward_viewer,
                               std::span<const float> projected, const float* arriving) const {
  const int index = bsdf_of_material_[material];
  if (index < 0) return {};
  const Lobe& lobe = lobes_[static_cast<std::size_t>(index)];
  const Frame frame(normal);
  const Vec3 out = frame.to_local(toward_viewer);
  Rgb sum, white;
  for (std::size_t in = 0; in < bins_.count(); ++in) {
    if (projected[in] > 0.0F) continue;
    const float* light = arriving + channels * in;
    const Rgb value = lobe.bsdf.evaluate(out, -frame.to_local(bins_.direction(in))).value;
    sum += value * Rgb(light[0], light[1], light[2]);
    white += value * -projected[in];
  }
  const Rgb albedo = lobe.albedo.at(out.z);
  for (int c = 0; c < 3; ++c) sum[c] *= corrected(white[c], albedo[c]);
  return sum;
}

LeafLobe::LeafLobe(const GlossyReflection& glossy, std::size_t leaf, const Vec3& normal, std::span<const float> projected)
    : lobe_(glossy.lobes_[static_cast<std::size_t>(glossy.bsdf_of_leaf_[leaf])]), frame_(normal) {
  for (std::size_t b = 0; b < projected.size(); ++b) {
    if (!(projected[b] > 0.0F)) continue;
    bins_.push_back(b);
    local_.push_back(frame_.to_local(glossy.bins_.direction(b)));
    projected_.push_back(projected[b]);
  }
  values_.resize(bins_.size());
}

void LeafLobe::reflect(const Vec3& toward_light, const Rgb& irradiance, float* exitant) {
  const Vec3 in = frame_.to_local(toward_light);
  Rgb sum;
  for (std::size_t k = 0; k < bins_.size(); ++k) {
    values_[k] = lobe_.bsdf.evaluate(local_[k], in).value;
    sum += values_[k] * projected_[k];
  }
  const Rgb albedo = lobe_.albedo.at(in.z);
  for (std::size_t c = 0; c < channels; ++c) {
    const auto channel = static_cast<int>(c);
    const float scale = corrected(sum[channel], albedo[channel]) * irradiance[channel];
    for (std::size_t k = 0; k < bins_.size(); ++k) exitant[channels * bins_[k] + c] += values_[k][channel] * scale;
  }
}

}  // namespace gibench::antiradiance
