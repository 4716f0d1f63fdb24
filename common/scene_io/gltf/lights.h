/// The lights of a glTF document.
#pragma once

#include "common/scene_io/gltf/nodes.h"
#include "common/scene_io/model.h"

namespace gibench {

/// Adds the light (KHR_lights_punctual) that hangs on a node, if there is one. Candela and lux are taken for W/sr and W/m²
/// one to one. A light that cannot be used gives a warning.
void add_gltf_light(const GltfDocument& document, const GltfNode& node, Model& model);

}  // namespace gibench
