#include "common/scene_io/obj/mtl_material.h"

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

constexpr int highlight_model = 2;  // illum: diffuse and highlight

/// Blinn's exponent n and the α of a rough surface mean about the same highlight for n = 2/α² − 2 (Walter et al. 2007), and
/// α = roughness².
float roughness_of_exponent(float exponent) { return std::pow(2.0F / (exponent + 2.0F), 0.25F); }
float exponent_of_roughness(float roughness) { return std::max(0.0F, 2.0F / std::max(1e-6F, std::pow(roughness, 4.0F)) - 2.0F); }

class MtlReader {
 public:
  MtlReader(const MtlMaterial& stated, const PictureUse& use, ModelPictures& pictures, MaterialRemarks& remarks)
      : stated_(stated), use_(use), pictures_(pictures), remarks_(remarks) {}

  Material read() {
    Material material;
    material.name = stated_.name;
    for (const std::string& remark : stated_.remarks) remarks_.add(remark);
    const Rgb diffuse = remarks_.clamped(diffuse_colour(), 1.0F, "the diffuse colour");
    const float metal = remarks_.clamped(stated_.metal, 1.0F, "Pm");
    if (metal > 0.0F) make_metal(diffuse, metal, material);
    else make_plastic(diffuse, material);
    const Rgb emission = times_picture(stated_.emission, stated_.emission_picture, Rgb());
    material.emission = remarks_.clamped(emission, 1e30F, "the emission");
    const int illumination = stated_.illumination.value_or(highlight_model);
    remarks_.note_transparency(illumination, stated_.opacity < 1.0F);
    return material;
  }

 private:
  Rgb diffuse_colour() {
    if (!stated_.diffuse && !stated_.diffuse_picture) remarks_.add("it has no Kd, 0.6 is used");
    return times_picture(stated_.diffuse, stated_.diffuse_picture, Rgb(default_albedo));
  }

  /// The colour times the mean of its picture; `otherwise` without both.
  Rgb times_picture(const std::optional<Rgb>& colour, const std::optional<MtlPicture>& picture, const Rgb& otherwise) {
    if (!picture) return colour.value_or(otherwise);
    PictureUse placed = use_;
    for (UvTriangle& triangle : placed.triangles)
      for (Vec2& corner : triangle) corner = picture->scale * corner + picture->offset;
    const Wrap wrap = picture->is_clamped ? Wrap::clamp : Wrap::repeat;
    const auto mean = pictures_.mean(picture->file, placed, {wrap, wrap}, remarks_);
    return mean ? colour.value_or(Rgb(1.0F)) * *mean : colour.value_or(otherwise);
  }

  void make_metal(const Rgb& base, float metal, Material& material) {
    blend_metal(base, metal, material);
    const float as_exponent = roughness_of_exponent(std::max(0.0F, stated_.exponent.value_or(0.0F)));
    material.roughness = remarks_.clamped(stated_.roughness.value_or(as_exponent), 1.0F, "Pr");
    if (stated_.specular && *stated_.specular != Rgb(1.0F) && !is_black(*stated_.specular))
      remarks_.add("Ks is not used: Pm says that it is a metal, of the colour Kd");
  }

  void make_plastic(const Rgb& diffuse, Material& material) {
    material.diffuse = diffuse;
    const Rgb specular = times_picture(stated_.specular, stated_.specular_picture, Rgb());
    if (stated_.roughness && stated_.exponent && !is_black(specular)) remarks_.add("Pr is not used, the highlight is Ks and Ns");
    const float exponent = stated_.exponent    ? *stated_.exponent
                           : stated_.roughness ? exponent_of_roughness(*stated_.roughness)
                                               : 0.0F;
    remarks_.add_highlight(material, specular, exponent, stated_.illumination.value_or(highlight_model));
  }

  const MtlMaterial& stated_;
  const PictureUse& use_;
  ModelPictures& pictures_;
  MaterialRemarks& remarks_;
};

}  // namespace

Material material_of(const MtlMaterial& stated, const PictureUse& use, ModelPictures& pictures, MaterialRemarks& remarks) {
  return MtlReader(stated, use, pictures, remarks).read();
}

}  // namespace gibench
