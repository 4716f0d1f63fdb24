/// The changes that a material of a model goes through, and what is left out of it, as one warning.
#pragma once

#include <string>
#include <vector>

#include "common/scene_io/model.h"

namespace gibench {

/// Brings the values of a material into their ranges; collects a remark for each change and for what is not simulated.
class MaterialRemarks {
 public:
  void add(std::string remark) { remarks_.push_back(std::move(remark)); }

  /// Into [0, limit]; NaN becomes 0.
  float clamped(float value, float limit, const char* what);
  Rgb clamped(const Rgb& value, float limit, const char* what);

  /// Adds a highlight to a diffuse material, as illumination model `illumination` of MTL says: none below 2, a mirror for
  /// 3 and 5, else a Phong lobe. Values are clamped; diffuse + specular above 1 is scaled down.
  void add_highlight(Material& material, const Rgb& specular, float exponent, int illumination);

  /// A remark where such an illumination model refracts, or the surface lets light through.
  void note_transparency(int illumination, bool lets_light_through);

  /// Adds "FILE: material NAME: remarks" where there are any.
  void warn(const std::string& file, const std::string& material, std::vector<std::string>& warnings) const;

 private:
  std::vector<std::string> remarks_;
};

/// Makes a material GGX: a dielectric over a diffuse base, blended into a metal of the colour of the base (glTF 2.0,
/// Appendix B). `metal` is in [0, 1].
void blend_metal(const Rgb& base, float metal, Material& material);

/// Of surfaces without a material: a light grey.
inline constexpr float default_albedo = 0.6F;
ModelMaterial default_material();

}  // namespace gibench
