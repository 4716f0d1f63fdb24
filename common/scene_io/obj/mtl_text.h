/// The materials of an MTL file, as it states them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

/// A picture of a material, and where its texture points lie in it: scale times point plus offset.
struct MtlPicture {
  std::string file;
  Vec2 scale{1.0F}, offset{0.0F};
  bool is_clamped = false;  ///< outside [0, 1] the border goes on instead of a repetition
};

/// One `newmtl`. What is absent was not stated.
struct MtlMaterial {
  std::string name;
  std::optional<Rgb> diffuse, specular, emission;  ///< Kd, Ks, Ke
  std::optional<float> exponent, roughness;        ///< Ns, Pr
  float metal = 0.0F, opacity = 1.0F;              ///< Pm; d, or 1 − Tr
  std::optional<int> illumination;                 ///< illum
  std::optional<MtlPicture> diffuse_picture, specular_picture, emission_picture;
  std::vector<std::string> remarks;  ///< statements that are left out, and what is wrong with others
};

/// Everything that was read.
struct MtlText {
  std::vector<MtlMaterial> materials;
  std::set<std::string> unknown_statements;
  std::vector<std::string> warnings;
};

/// Reads the text of an MTL file. Refuses nothing: what is not understood is told.
MtlText parse_mtl(std::string_view text);

}  // namespace gibench
