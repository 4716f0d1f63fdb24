/// Punctual lights and cameras of Assimp's scenes, in file coordinates.
#pragma once

#include <assimp/scene.h>

#include "common/scene_io/model.h"

namespace gibench {

void read_model_lights(const aiScene& scene, Model& model);
void read_model_cameras(const aiScene& scene, Model& model);

}  // namespace gibench
