/// Model files (OBJ, PLY, glTF, STL, …) through Assimp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/scene/scene_builder.h"

namespace gibench {

/// The faces of one node with one material, in file coordinates with the node's transform applied.
struct ModelPart {
  std::string name;          ///< of the node or its mesh; may be empty
  std::size_t material = 0;  ///< index into ModelFile::materials
  ObjectGeometry geometry;
};

struct ModelMaterial {
  Material material;
  bool two_sided = false;
};

struct ModelLight {
  Light light;
  Vec3d position{0.0};  ///< file coordinates; unused by directional lights
};

struct ModelCamera {
  Camera camera;
  Vec3d position{0.0}, look_at{0.0};
};

struct ModelFile {
  std::vector<ModelPart> parts;
  std::vector<ModelMaterial> materials;
  std::vector<ModelLight> lights;
  std::vector<ModelCamera> cameras;
  std::vector<std::string> warnings;
};

/// Whether Assimp reads files that are named so.
bool is_model_name(const std::filesystem::path& file);

/// Reads geometry with quads kept as quads and larger polygons triangulated; points and lines are left out with a
/// warning. Meshes that Assimp hands out with one vertex a corner (OBJ, STL) are joined by equal positions, so duplicate
/// vertices inside them are not told apart; other meshes keep the vertices of the file. Positions of OBJ and ASCII STL
/// files are read in double precision, others as the single precision that Assimp keeps. Photometric units (glTF:
/// candela, lux, nit) are taken as radiometric ones (W/sr, W/m², W/(m² sr)) one to one. Throws InputError at `place`
/// for a file that is no model, is cut short, has no faces or a face whose index is out of range.
/// `with_materials` false leaves materials at their defaults and reads no pictures.
ModelFile read_model(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
