#include "common/scene_io/assimp/model_materials.h"

#include <assimp/material.h>

#include "common/scene_io/assimp/embedded_pictures.h"
#include "common/scene_io/assimp/model_name.h"
#include "common/scene_io/model_parts/material_remarks.h"

namespace gibench {

namespace {

// Diffuse and highlight, as MTL numbers illumination models.
constexpr int illumination_model = 2;

/// Reads one material; what is not simulated or had to be changed is collected as remarks.
class MaterialReader {
 public:
  MaterialReader(const aiMaterial& source, const PictureUse& use, ModelPictures& pictures)
      : source_(source), use_(use), pictures_(pictures) {}

  Material read() {
    Material material;
    material.name = source_.GetName().C_Str();
    float metallic = 0.0F;
    if (source_.Get(AI_MATKEY_METALLIC_FACTOR, metallic) == AI_SUCCESS) read_metallic_roughness(material, metallic);
    else read_phong(material);
    read_emission(material);
    note_what_is_left_out();
    return material;
  }

  const MaterialRemarks& remarks() const { return remarks_; }

 private:
  Rgb colour(const char* key, unsigned type, unsigned index) const {
    aiColor3D value(0.0F, 0.0F, 0.0F);
    source_.Get(key, type, index, value);
    return {value.r, value.g, value.b};
  }

  float number(const char* key, unsigned type, unsigned index, float fallback) const {
    float value = fallback;
    source_.Get(key, type, index, value);
    return value;
  }

  /// `factor` times the mean of the picture of this type, if there is one.
  Rgb times_picture(Rgb factor, aiTextureType type) {
    aiString name;
    aiTextureMapMode modes[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    if (source_.GetTexture(type, 0, &name, nullptr, nullptr, nullptr, nullptr, modes) != AI_SUCCESS) return factor;
    aiUVTransform transform;
    if (source_.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == AI_SUCCESS && !is_identity(transform))
      remarks_.add("the transform of its texture points is left out");
    const auto mean = pictures_.mean(name.C_Str(), use_, {wrap_of(modes[0]), wrap_of(modes[1])}, remarks_);
    return mean ? factor * *mean : factor;
  }

  static bool is_identity(const aiUVTransform& transform) {
    return transform.mTranslation == aiVector2D(0.0F, 0.0F) && transform.mScaling == aiVector2D(1.0F, 1.0F) &&
           transform.mRotation == 0.0F;
  }

  static Wrap wrap_of(aiTextureMapMode mode) {
    return mode == aiTextureMapMode_Clamp ? Wrap::clamp : mode == aiTextureMapMode_Mirror ? Wrap::mirror : Wrap::repeat;
  }

  /// Most older formats: diffuse colour and Phong highlight.
  void read_phong(Material& material) {
    const Rgb diffuse = times_picture(colour(AI_MATKEY_COLOR_DIFFUSE), aiTextureType_DIFFUSE);
    material.diffuse = remarks_.clamped(diffuse, 1.0F, "the diffuse colour");
    Rgb specular = colour(AI_MATKEY_COLOR_SPECULAR);
    if (const float strength = number(AI_MATKEY_SHININESS_STRENGTH, 1.0F); strength > 0.0F && strength < 1.0F)
      specular *= strength;
    remarks_.add_highlight(material, specular, number(AI_MATKEY_SHININESS, 0.0F), illumination_model);
  }

  /// glTF: a dielectric under a diffuse base, blended into a metal (glTF 2.0, Appendix B).
  void read_metallic_roughness(Material& material, float metallic) {
    aiTextureType picture = aiTextureType_BASE_COLOR;
    if (source_.GetTextureCount(picture) == 0) picture = aiTextureType_DIFFUSE;
    const Rgb base = remarks_.clamped(times_picture(colour(AI_MATKEY_BASE_COLOR), picture), 1.0F, "the base colour");
    const float metal = remarks_.clamped(metallic, 1.0F, "the metallic factor");
    blend_metal(base, metal, material);
    material.roughness = remarks_.clamped(number(AI_MATKEY_ROUGHNESS_FACTOR, 1.0F), 1.0F, "the roughness factor");
    if (source_.GetTextureCount(aiTextureType_METALNESS) + source_.GetTextureCount(aiTextureType_DIFFUSE_ROUGHNESS) > 0)
      remarks_.add("the metallic-roughness picture is not used");
  }

  void read_emission(Material& material) {
    const Rgb emission = times_picture(colour(AI_MATKEY_COLOR_EMISSIVE), aiTextureType_EMISSIVE);
    material.emission = remarks_.clamped(emission, 1e30F, "the emission");
  }

  void note_what_is_left_out() {
    remarks_.note_transparency(illumination_model,
                               number(AI_MATKEY_OPACITY, 1.0F) < 1.0F || number(AI_MATKEY_TRANSMISSION_FACTOR, 0.0F) > 0.0F);
  }

  const aiMaterial& source_;
  const PictureUse& use_;
  ModelPictures& pictures_;
  MaterialRemarks remarks_;
};

/// Assimp makes up a material where a file has none; its colours differ between formats and mean nothing.
bool is_made_up(const aiMaterial& material) {
  const std::string name = material.GetName().C_Str();
  return name == AI_DEFAULT_MATERIAL_NAME || name.empty();
}

/// What its pictures are taken over; nothing where it has none.
PictureUse use_of(const aiScene& scene, unsigned material) {
  unsigned pictures = 0;
  for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR, aiTextureType_EMISSIVE})
    pictures += scene.mMaterials[material]->GetTextureCount(type);
  return pictures > 0 ? picture_use(scene, material) : PictureUse();
}

}  // namespace

void read_model_materials(const aiScene& scene, const std::filesystem::path& file, const std::vector<bool>& used, Model& model) {
  ModelPictures pictures = pictures_of(scene, file.parent_path());
  const std::string shown = file.filename().string();
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& source = *scene.mMaterials[i];
    model.materials.push_back(default_material());
    if (!used[i]) continue;
    if (is_made_up(source)) {
      model.warnings.push_back(shown + ": no material; diffuse with albedo 0.6 is used");
      continue;
    }
    const PictureUse use = use_of(scene, i);
    MaterialReader reader(source, use, pictures);
    ModelMaterial& made = model.materials.back();
    made.material = reader.read();
    if (made.material.name.empty()) made.material.name = "material-" + std::to_string(i);
    source.Get(AI_MATKEY_TWOSIDED, made.two_sided);
    reader.remarks().warn(shown, made.material.name, model.warnings);
  }
}

}  // namespace gibench
