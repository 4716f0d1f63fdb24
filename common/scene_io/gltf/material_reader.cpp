#include "common/scene_io/gltf/material_reader.h"

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

// Strongest emission, W/(m² sr), far below where single precision ends.
constexpr double most_emission = 1e30;

Rgb rgb_of(const std::array<double, 3>& c) {
  return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}
template <std::size_t count>
Rgb first_three(const std::array<double, count>& c) {
  return rgb_of({c[0], c[1], c[2]});
}

/// NaN becomes 0.
float into_unit(float value) { return value > 1.0F ? 1.0F : value > 0.0F ? value : 0.0F; }

}  // namespace

/// Into [0, 1].
float GltfMaterialReader::unit(double value, const char* what) {
  if (!(value >= 0.0 && value <= 1.0)) remarks_.push_back(std::string(what) + " is clamped to its range");
  return into_unit(static_cast<float>(value));
}

Rgb GltfMaterialReader::unit(const Rgb& value, const char* what) {
  const auto is_in = [](float x) { return x >= 0.0F && x <= 1.0F; };
  if (!is_in(value.r) || !is_in(value.g) || !is_in(value.b)) remarks_.push_back(std::string(what) + " is clamped to its range");
  return {into_unit(value.r), into_unit(value.g), into_unit(value.b)};
}

std::optional<PictureMean> GltfMaterialReader::mean(const GltfValue& owner, const char* key, TexelValues values, AlphaUse alpha) {
  const auto info = owner.find(key);
  return info ? pictures_.mean(*info, primitive_, values, alpha, remarks_) : std::nullopt;
}

/// COLOR_0, linear, its mean over the primitive by area; white where there is none.
GltfMaterialReader::Base GltfMaterialReader::vertex_colour() {
  const auto colours = primitive_.attribute(document_, "COLOR_0");
  Base base{Rgb(1.0F), 1.0};
  if (!colours) return base;
  if (colours->components < 3) primitive_.value.refuse("has a COLOR_0 of less than three numbers per vertex");
  const std::vector<double> areas = primitive_.areas();
  RgbDouble sum;
  double alpha = 0.0, area = 0.0;
  for (std::size_t t = 0; t < areas.size(); ++t)
    for (const std::uint32_t corner : primitive_.triangles[t]) {
      const double* row = colours->row(corner);
      sum += areas[t] * RgbDouble(row[0], row[1], row[2]);
      alpha += areas[t] * (colours->components > 3 ? row[3] : 1.0);
      area += areas[t];
    }
  if (!(area > 0.0)) return base;
  remarks_.emplace_back("vertex colours are replaced by their mean");
  return {Rgb(sum / area), alpha / area};
}

/// What alpha does in a picture that a factor is multiplied with (glTF 2.0, 3.9.6).
AlphaUse GltfMaterialReader::alpha_use(double factor) const {
  const std::string mode = material_.text_or("alphaMode", "OPAQUE");
  if (mode == "BLEND") return {AlphaUse::Mode::weighs};
  if (mode == "MASK") return {AlphaUse::Mode::cuts, factor > 0.0 ? material_.number_or("alphaCutoff", 0.5) / factor : 2.0};
  return {};
}

/// Factor × picture × vertex colour; of the last two the means.
GltfMaterialReader::Base GltfMaterialReader::read_base(const GltfValue& owner, const char* factor_key, const char* picture_key) {
  const auto factor = owner.numbers_or<4>(factor_key, {1.0, 1.0, 1.0, 1.0});
  const Base vertices = vertex_colour();
  const AlphaUse alpha = alpha_use(factor[3]);
  const auto picture = mean(owner, picture_key, TexelValues::srgb, alpha);
  Base base{first_three(factor) * vertices.colour, factor[3] * vertices.opacity};
  if (picture) base.colour = base.colour * picture->colour;
  switch (alpha.mode) {
    case AlphaUse::Mode::ignored: base.opacity = 1.0; break;
    case AlphaUse::Mode::cuts:
      base.opacity = picture ? picture->opacity : base.opacity >= alpha.threshold * factor[3] ? 1.0 : 0.0;
      break;
    case AlphaUse::Mode::weighs: base.opacity *= picture ? picture->opacity : 1.0; break;
  }
  base.colour = unit(base.colour, "the base colour");
  opacity_ = base.opacity;
  return base;
}

/// Reflectance at normal incidence of what is not a metal: 0.04, or by KHR_materials_ior and KHR_materials_specular.
Rgb GltfMaterialReader::dielectric_f0() {
  double ior = 1.5;
  if (const auto extension = material_.extension("KHR_materials_ior")) ior = extension->number_or("ior", ior);
  if (ior != 0.0 && !(ior >= 1.0)) material_.refuse("has an index of refraction below 1");
  const double root = ior == 0.0 ? 1.0 : (ior - 1.0) / (ior + 1.0);  // 0 stands for a reflectance of 1
  const Rgb f0(static_cast<float>(root * root));
  const auto specular = material_.extension("KHR_materials_specular");
  if (!specular) return f0;
  if (specular->has("specularTexture") || specular->has("specularColorTexture"))
    remarks_.emplace_back("the pictures of KHR_materials_specular are not used");
  const Rgb colour = rgb_of(specular->numbers_or<3>("specularColorFactor", {1.0, 1.0, 1.0}));
  const Rgb tinted = f0 * colour, most{std::min(tinted.r, 1.0F), std::min(tinted.g, 1.0F), std::min(tinted.b, 1.0F)};
  return unit(most * unit(specular->number_or("specularFactor", 1.0), "the specular factor"), "the specular colour");
}

/// A dielectric over a diffuse base, blended into a metal (glTF 2.0, Appendix B).
void GltfMaterialReader::read_metallic_roughness(Material& material) {
  const GltfValue values = material_.object("pbrMetallicRoughness");
  const Base base = read_base(values, "baseColorFactor", "baseColorTexture");
  double metal = values.number_or("metallicFactor", 1.0), roughness = values.number_or("roughnessFactor", 1.0);
  if (const auto picture = mean(values, "metallicRoughnessTexture", TexelValues::data)) {
    roughness *= static_cast<double>(picture->colour.g);
    metal *= static_cast<double>(picture->colour.b);
  }
  const float share = unit(metal, "the metallic factor");
  const Rgb dielectric = dielectric_f0();
  material.bsdf = Bsdf::ggx;
  material.roughness = unit(roughness, "the roughness factor");
  material.f0 = (1.0F - share) * dielectric + share * base.colour;
  material.diffuse = (1.0F - largest(dielectric)) * (1.0F - share) * base.colour;
}

/// KHR_materials_pbrSpecularGlossiness: the specular colour is the reflectance at normal incidence.
void GltfMaterialReader::read_specular_glossiness(const GltfValue& extension, Material& material) {
  const Base base = read_base(extension, "diffuseFactor", "diffuseTexture");
  Rgb specular = rgb_of(extension.numbers_or<3>("specularFactor", {1.0, 1.0, 1.0}));
  double glossiness = extension.number_or("glossinessFactor", 1.0);
  // The glossiness is in the alpha channel.
  if (const auto picture = mean(extension, "specularGlossinessTexture", TexelValues::srgb, {AlphaUse::Mode::weighs}))
    glossiness *= picture->opacity;
  if (const auto picture = mean(extension, "specularGlossinessTexture", TexelValues::srgb)) specular = specular * picture->colour;
  material.bsdf = Bsdf::ggx;
  material.f0 = unit(specular, "the specular factor");
  material.roughness = 1.0F - unit(glossiness, "the glossiness factor");
  material.diffuse = (1.0F - largest(material.f0)) * base.colour;
}

/// KHR_materials_unlit: the same radiance whatever the light.
void GltfMaterialReader::read_unlit(Material& material) {
  material.emission = read_base(material_.object("pbrMetallicRoughness"), "baseColorFactor", "baseColorTexture").colour;
  remarks_.emplace_back("unlit: it emits its base colour and reflects nothing");
}

void GltfMaterialReader::read_emission(Material& material) {
  auto factor = material_.numbers_or<3>("emissiveFactor", {0.0, 0.0, 0.0});
  double strength = 1.0;
  if (const auto extension = material_.extension("KHR_materials_emissive_strength"))
    strength = extension->number_or("emissiveStrength", strength);
  const bool is_dark = factor == std::array<double, 3>{0.0, 0.0, 0.0} || strength == 0.0;
  std::optional<PictureMean> picture;
  if (!is_dark) picture = mean(material_, "emissiveTexture", TexelValues::srgb);
  bool is_clamped = false;
  for (std::size_t c = 0; c < 3; ++c) {
    factor[c] *= strength * static_cast<double>(picture ? picture->colour[static_cast<int>(c)] : 1.0F);
    const double clamped = std::clamp(factor[c], 0.0, most_emission);
    is_clamped = is_clamped || clamped != factor[c];
    factor[c] = clamped;
  }
  if (is_clamped) remarks_.emplace_back("the emission is clamped to its range");
  material.emission = rgb_of(factor);
}

void GltfMaterialReader::note_what_is_left_out(double opacity) {
  if (opacity < 1.0)
    remarks_.push_back("alpha is below 1 in places (alphaMode " + material_.text_or("alphaMode", "OPAQUE") +
                       "): transparency is not simulated, the surface is opaque");
  if (const auto glass = material_.extension("KHR_materials_transmission");
      glass && glass->number_or("transmissionFactor", 0.0) > 0.0)
    remarks_.emplace_back("transparency is not simulated, the surface is opaque");
  if (material_.has("normalTexture")) remarks_.emplace_back("the normal picture is not used");
  if (material_.has("occlusionTexture")) remarks_.emplace_back("the occlusion picture is not used");
}

ModelMaterial GltfMaterialReader::read() {
  ModelMaterial made;
  Material& material = made.material;
  material.name = material_.text_or("name", "");
  made.two_sided = material_.flag_or("doubleSided", false);
  if (material_.extension("KHR_materials_unlit")) {
    read_unlit(material);
  } else {
    if (const auto extension = material_.extension("KHR_materials_pbrSpecularGlossiness"))
      read_specular_glossiness(*extension, material);
    else read_metallic_roughness(material);
    read_emission(material);
  }
  note_what_is_left_out(opacity_);
  return made;
}

}  // namespace gibench
