#include "common/scene_io/assimp/model_materials.h"

#include <assimp/material.h>

#include <cmath>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/assimp/picture_mean.h"

namespace gibench {

namespace {

// "illum" of an MTL file, which Assimp keeps under this name (a macro of its own that is in no header of 5.2).
constexpr const char* obj_illumination_key = "$mat.illum";

// A model without materials: a light grey.
constexpr float default_albedo = 0.6F;
// Reflectance at normal incidence of a glTF material that is not a metal (glTF 2.0, Appendix B.2).
constexpr float dielectric_f0 = 0.04F;

/// Reads one material; what is not simulated or had to be changed is collected as remarks.
class MaterialReader {
 public:
  MaterialReader(const aiMaterial& source, PictureMeans& pictures) : source_(source), pictures_(pictures) {}

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

  const std::vector<std::string>& remarks() const { return remarks_; }

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

  /// Of MTL files; 2 (diffuse and highlight) for other formats.
  int illumination_model() const {
    int model = 2;
    source_.Get(obj_illumination_key, 0, 0, model);
    return model;
  }

  /// `factor` times the mean of the picture of this type, if there is one.
  Rgb times_picture(Rgb factor, aiTextureType type) {
    aiString name;
    if (source_.GetTexture(type, 0, &name) != AI_SUCCESS) return factor;
    try {
      const Rgb mean = pictures_.mean(name.C_Str());
      remarks_.push_back("the picture " + in_quotes(name.C_Str()) + " is replaced by its mean");
      return factor * mean;
    } catch (const InputError& error) {
      remarks_.push_back("a picture is not used (" + std::string(error.what()) + ")");
      return factor;
    }
  }

  /// Into [0, largest allowed], NaN to 0.
  float clamped(float value, float limit, const char* what) {
    if (value >= 0.0F && value <= limit) return value;
    remarks_.push_back(std::string(what) + " is clamped to its range");
    return value > limit ? limit : 0.0F;
  }
  Rgb clamped(const Rgb& value, float limit, const char* what) {
    if (smallest(value) >= 0.0F && largest(value) <= limit) return value;
    remarks_.push_back(std::string(what) + " is clamped to its range");
    const auto clamp = [&](float x) { return x > limit ? limit : x > 0.0F ? x : 0.0F; };
    return {clamp(value.r), clamp(value.g), clamp(value.b)};
  }

  /// OBJ and most older formats: diffuse colour, Phong highlight, mirror by the illumination model of MTL.
  void read_phong(Material& material) {
    const int illumination = illumination_model();
    material.diffuse = clamped(times_picture(colour(AI_MATKEY_COLOR_DIFFUSE), aiTextureType_DIFFUSE), 1.0F, "the diffuse colour");
    Rgb specular = clamped(colour(AI_MATKEY_COLOR_SPECULAR), 1.0F, "the specular colour");
    if (const float strength = number(AI_MATKEY_SHININESS_STRENGTH, 1.0F); strength > 0.0F && strength < 1.0F)
      specular *= strength;
    if (is_black(specular)) return;
    if (illumination < 2) {
      remarks_.push_back("illum " + std::to_string(illumination) + " leaves out the specular colour");
      return;
    }
    if (illumination == 3 || illumination == 5) return make_mirror(material, specular);
    material.bsdf = Bsdf::phong;
    material.specular = specular;
    material.exponent = clamped(number(AI_MATKEY_SHININESS, 0.0F), 1e6F, "the exponent");
    keep_energy(material);
  }

  void make_mirror(Material& material, const Rgb& reflectance) {
    if (!is_black(material.diffuse)) remarks_.push_back("the diffuse colour of a mirror is left out");
    material.bsdf = Bsdf::mirror;
    material.diffuse = Rgb();
    material.reflectance = reflectance;
  }

  void keep_energy(Material& material) {
    const float sum = largest(material.diffuse + material.specular);
    if (sum <= 1.0F) return;
    material.diffuse /= sum;
    material.specular /= sum;
    remarks_.push_back("diffuse + specular was above 1 and is scaled down to 1");
  }

  /// glTF: a dielectric under a diffuse base, blended into a metal (glTF 2.0, Appendix B).
  void read_metallic_roughness(Material& material, float metallic) {
    aiTextureType picture = aiTextureType_BASE_COLOR;
    if (source_.GetTextureCount(picture) == 0) picture = aiTextureType_DIFFUSE;
    const Rgb base = clamped(times_picture(colour(AI_MATKEY_BASE_COLOR), picture), 1.0F, "the base colour");
    const float metal = clamped(metallic, 1.0F, "the metallic factor");
    material.bsdf = Bsdf::ggx;
    material.roughness = clamped(number(AI_MATKEY_ROUGHNESS_FACTOR, 1.0F), 1.0F, "the roughness factor");
    material.f0 = Rgb(dielectric_f0 * (1.0F - metal)) + metal * base;
    material.diffuse = (1.0F - dielectric_f0) * (1.0F - metal) * base;
    if (source_.GetTextureCount(aiTextureType_METALNESS) + source_.GetTextureCount(aiTextureType_DIFFUSE_ROUGHNESS) > 0)
      remarks_.emplace_back("the metallic-roughness picture is not used");
  }

  void read_emission(Material& material) {
    const Rgb emission = times_picture(colour(AI_MATKEY_COLOR_EMISSIVE), aiTextureType_EMISSIVE);
    material.emission = clamped(emission, 1e30F, "the emission");
  }

  void note_what_is_left_out() {
    const int illumination = illumination_model();
    const bool refracts = illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
    if (refracts || number(AI_MATKEY_OPACITY, 1.0F) < 1.0F || number(AI_MATKEY_TRANSMISSION_FACTOR, 0.0F) > 0.0F)
      remarks_.emplace_back("transparency is not simulated, the surface is opaque");
  }

  const aiMaterial& source_;
  PictureMeans& pictures_;
  std::vector<std::string> remarks_;
};

/// Assimp makes up a material where a file has none; its colours differ between formats and mean nothing.
bool is_made_up(const aiMaterial& material) {
  const std::string name = material.GetName().C_Str();
  return name == AI_DEFAULT_MATERIAL_NAME || name.empty();
}

ModelMaterial default_material() {
  ModelMaterial made;
  made.material.name = "default";
  made.material.diffuse = Rgb(default_albedo);
  return made;
}

std::string joined(const std::vector<std::string>& remarks) {
  std::string text;
  for (const std::string& remark : remarks) text += (text.empty() ? "" : "; ") + remark;
  return text;
}

}  // namespace

void read_model_materials(const aiScene& scene, const std::filesystem::path& file, const std::vector<bool>& used, Model& model) {
  PictureMeans pictures(scene, file.parent_path());
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& source = *scene.mMaterials[i];
    model.materials.push_back(default_material());
    if (!used[i]) continue;
    if (is_made_up(source)) {
      model.warnings.push_back(file.filename().string() + ": no material; diffuse with albedo 0.6 is used");
      continue;
    }
    MaterialReader reader(source, pictures);
    ModelMaterial& made = model.materials.back();
    made.material = reader.read();
    if (made.material.name.empty()) made.material.name = "material-" + std::to_string(i);
    source.Get(AI_MATKEY_TWOSIDED, made.two_sided);
    if (!reader.remarks().empty())
      model.warnings.push_back(file.filename().string() + ": material " + in_quotes(made.material.name) + ": " +
                               joined(reader.remarks()));
  }
}

}  // namespace gibench
