/// The nodes of a glTF scene with their transforms.
#pragma once

#include <vector>

#include "common/scene/transform.h"
#include "common/scene_io/gltf/document.h"

namespace gibench {

/// A node that is part of the scene.
struct GltfNode {
  GltfValue value;
  Transform to_file;  ///< from the node's coordinates to the file's, multiplied in double precision
};

/// Parents before their children, in the file's order: those of the file's default scene, or all where it has no scene.
/// InputError for a node that is its own descendant or has two parents.
std::vector<GltfNode> scene_nodes(const GltfDocument& document);

}  // namespace gibench
