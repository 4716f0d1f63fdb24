/// One material of a glTF document on one primitive.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/scene_io/gltf/pictures.h"
#include "common/scene_io/model.h"

namespace gibench {

/// Reads metallic-roughness (glTF 2.0, Appendix B), specular-glossiness and unlit materials with their pictures and the
/// primitive's vertex colours.
class GltfMaterialReader {
 public:
  GltfMaterialReader(GltfDocument& document, GltfValue material, const GltfPrimitive& primitive, GltfPictures& pictures)
      : document_(document), material_(std::move(material)), primitive_(primitive), pictures_(pictures) {}

  ModelMaterial read();
  /// What is not simulated or was out of range.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  /// A colour, and the share of the surface that is there.
  struct Base {
    Rgb colour;
    double opacity = 1.0;
  };

  float unit(double value, const char* what);
  Rgb unit(const Rgb& value, const char* what);
  std::optional<PictureMean> mean(const GltfValue& owner, const char* key, TexelValues values, AlphaUse alpha = {});
  Base read_base(const GltfValue& owner, const char* factor_key, const char* picture_key);
  Base vertex_colour();
  AlphaUse alpha_use(double factor) const;

  void read_metallic_roughness(Material& material);
  void read_specular_glossiness(const GltfValue& extension, Material& material);
  void read_unlit(Material& material);
  Rgb dielectric_f0();
  void read_emission(Material& material);
  void note_what_is_left_out(double opacity);

  GltfDocument& document_;
  GltfValue material_;
  const GltfPrimitive& primitive_;
  GltfPictures& pictures_;
  double opacity_ = 1.0;
  std::vector<std::string> remarks_;
};

}  // namespace gibench
