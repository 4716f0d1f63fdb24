/// Parts of reading a model out of Assimp's scene; only the model_*.cpp files include this.
#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "common/scene/transform.h"
#include "common/scene_io/assimp/model_file.h"

namespace gibench {

/// Vertices and faces of every mesh, without node transforms: triangles and quads as they are, larger polygons as
/// triangles. Warnings tell what was left out.
std::vector<ObjectGeometry> read_meshes(const aiScene& scene, const std::string& place, std::vector<std::string>& warnings);

/// Adds a ModelMaterial for every material of the scene. A material with anything that is not simulated or out of
/// range gives one warning.
void read_model_materials(const aiScene& scene, const std::filesystem::path& file, const std::vector<bool>& used,
                          ModelFile& model);

/// Punctual lights and cameras, in file coordinates.
void read_model_lights(const aiScene& scene, bool is_gltf, ModelFile& model);
void read_model_cameras(const aiScene& scene, bool is_gltf, ModelFile& model);

/// From a node's coordinates to the file's, multiplied in double precision.
Transform transform_of(const aiNode& node);
/// The same for the node of this name; the identity where there is none.
Transform transform_of(const aiScene& scene, const aiString& node_name);

inline Vec3d to_vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

std::string extension_of(const std::filesystem::path& file);  ///< in lower case, with the dot
inline bool is_gltf_name(const std::filesystem::path& file) {
  return extension_of(file) == ".gltf" || extension_of(file) == ".glb";
}

}  // namespace gibench
