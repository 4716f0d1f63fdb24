#include "common/scene_io/model_parts/material_remarks.h"

#include <fmt/format.h>

#include "common/core/names.h"

namespace gibench {

namespace {

void make_mirror(Material& material, const Rgb& reflectance, MaterialRemarks& remarks) {
  if (!is_black(material.diffuse)) remarks.add("the diffuse colour of a mirror is left out");
  material.bsdf = Bsdf::mirror;
  material.diffuse = Rgb();
  material.reflectance = reflectance;
}

void keep_energy(Material& material, MaterialRemarks& remarks) {
  const float sum = largest(material.diffuse + material.specular);
  if (sum <= 1.0F) return;
  material.diffuse /= sum;
  material.specular /= sum;
  remarks.add("diffuse + specular was above 1 and is scaled down to 1");
}

}  // namespace

float MaterialRemarks::clamped(float value, float limit, const char* what) {
  if (value >= 0.0F && value <= limit) return value;
  add(std::string(what) + " is clamped to its range");
  return value > limit ? limit : 0.0F;
}

Rgb MaterialRemarks::clamped(const Rgb& value, float limit, const char* what) {
  if (smallest(value) >= 0.0F && largest(value) <= limit) return value;
  add(std::string(what) + " is clamped to its range");
  const auto clamp = [&](float x) { return x > limit ? limit : x > 0.0F ? x : 0.0F; };
  return {clamp(value.r), clamp(value.g), clamp(value.b)};
}

void MaterialRemarks::add_highlight(Material& material, const Rgb& specular, float exponent, int illumination) {
  const Rgb reflectance = clamped(specular, 1.0F, "the specular colour");
  if (is_black(reflectance)) return;
  if (illumination < 2) return add("illum " + std::to_string(illumination) + " leaves out the specular colour");
  if (illumination == 3 || illumination == 5) return make_mirror(material, reflectance, *this);
  material.bsdf = Bsdf::phong;
  material.specular = reflectance;
  material.exponent = clamped(exponent, 1e6F, "the exponent");
  keep_energy(material, *this);
}

void MaterialRemarks::note_transparency(int illumination, bool lets_light_through) {
  const bool refracts = illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
  if (refracts || lets_light_through) add("transparency is not simulated, the surface is opaque");
}

void MaterialRemarks::warn(const std::string& file, const std::string& material, std::vector<std::string>& warnings) const {
  if (!remarks_.empty())
    warnings.push_back(fmt::format("{}: material {}: {}", file, in_quotes(material), fmt::join(remarks_, "; ")));
}

void blend_metal(const Rgb& base, float metal, Material& material) {
  constexpr float dielectric_f0 = 0.04F;  // at normal incidence of what is no metal (Appendix B.2)
  material.bsdf = Bsdf::ggx;
  material.f0 = Rgb(dielectric_f0 * (1.0F - metal)) + metal * base;
  material.diffuse = (1.0F - dielectric_f0) * (1.0F - metal) * base;
}

ModelMaterial default_material() {
  ModelMaterial made;
  made.material.name = "default";
  made.material.diffuse = Rgb(default_albedo);
  return made;
}

}  // namespace gibench
