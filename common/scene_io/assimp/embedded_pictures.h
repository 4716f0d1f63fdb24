/// The pictures of Assimp's scenes, inside the model or in files beside it.
#pragma once

#include <assimp/scene.h>

#include <filesystem>

#include "common/scene_io/model_parts/model_pictures.h"

namespace gibench {

/// Keeps a reference to the scene.
ModelPictures pictures_of(const aiScene& scene, const std::filesystem::path& folder);

/// Where the surfaces of a material lie in their pictures, by the first texture points of each mesh.
PictureUse picture_use(const aiScene& scene, unsigned material);

}  // namespace gibench
