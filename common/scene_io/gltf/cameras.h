/// The cameras of a glTF document.
#pragma once

#include "common/core/names.h"
#include "common/scene_io/gltf/nodes.h"
#include "common/scene_io/model.h"

namespace gibench {

/// Adds the camera of a node, if it has one, named after the node. One that cannot be used gives a warning.
void add_gltf_camera(const GltfDocument& document, const GltfNode& node, UniqueNames& names, Model& model);

}  // namespace gibench
