#include "common/scene_io/gltf/materials.h"

#include <algorithm>

#include "common/core/names.h"
#include "common/scene_io/gltf/material_reader.h"

namespace gibench {

namespace {

// A surface without a material: a light grey.
constexpr float default_albedo = 0.6F;

bool is_same(const ModelMaterial& a, const ModelMaterial& b) {
  const Material &x = a.material, &y = b.material;
  return a.two_sided == b.two_sided && x.name == y.name && x.bsdf == y.bsdf && x.diffuse == y.diffuse &&
         x.specular == y.specular && x.exponent == y.exponent && x.roughness == y.roughness && x.f0 == y.f0 &&
         x.reflectance == y.reflectance && x.emission == y.emission;
}

}  // namespace

std::size_t GltfMaterials::default_material() {
  if (!default_) {
    default_ = model_.materials.size();
    ModelMaterial& made = model_.materials.emplace_back();
    made.material.name = "default";
    made.material.diffuse = Rgb(default_albedo);
    model_.warnings.push_back(document_.file().filename().string() + ": no material; diffuse with albedo 0.6 is used");
  }
  return *default_;
}

std::size_t GltfMaterials::of(const GltfPrimitive& primitive) {
  const auto index = primitive.material();
  if (!index) return default_material();
  std::vector<std::string>& remarks = remarks_[*index];
  GltfMaterialReader reader(document_, document_.item("materials", *index), primitive, pictures_);
  ModelMaterial material = reader.read();
  if (material.material.name.empty()) material.material.name = "material-" + std::to_string(*index);
  for (const std::string& remark : reader.remarks())
    if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end()) remarks.push_back(remark);
  std::vector<std::size_t>& variants = variants_[*index];
  for (const std::size_t variant : variants)
    if (is_same(model_.materials[variant], material)) return variant;
  variants.push_back(model_.materials.size());
  model_.materials.push_back(std::move(material));
  return variants.back();
}

void GltfMaterials::warn() const {
  for (const auto& [index, remarks] : remarks_) {
    std::string text;
    for (const std::string& remark : remarks) text += (text.empty() ? "" : "; ") + remark;
    if (!text.empty())
      model_.warnings.push_back(document_.file().filename().string() + ": material " +
                                in_quotes(model_.materials[variants_.at(index).front()].material.name) + ": " + text);
  }
}

}  // namespace gibench
