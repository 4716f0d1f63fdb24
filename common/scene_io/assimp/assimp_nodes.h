/// Nodes of Assimp's scenes and their transforms, in gibench's types.
#pragma once

#include <assimp/scene.h>

#include "common/core/vec.h"
#include "common/scene/transform.h"

namespace gibench {

/// From a node's coordinates to the file's, multiplied in double precision.
Transform transform_of(const aiNode& node);
/// The same for the node of this name; the identity where there is none.
Transform transform_of(const aiScene& scene, const aiString& node_name);

inline Vec3d to_vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

}  // namespace gibench
