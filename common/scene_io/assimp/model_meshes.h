/// Meshes of Assimp's scenes.
#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "common/scene/scene_assembler.h"

namespace gibench {

/// Vertices and faces of every mesh, without node transforms: triangles and quads as they are, larger polygons as
/// triangles. Warnings say what was left out. Throws InputError at `place` for a face without corners or with an index
/// out of range.
std::vector<ObjectGeometry> read_meshes(const aiScene& scene, const std::string& place, std::vector<std::string>& warnings);

}  // namespace gibench
