#include "common/scene_io/models/read_model.h"

#include "common/scene_io/assimp/model_file.h"
#include "common/scene_io/gltf/gltf_file.h"

namespace gibench {

Model read_model(const std::filesystem::path& file, const std::string& place, bool with_materials) {
  return is_gltf_name(file) ? read_gltf(file, place, with_materials) : read_with_assimp(file, place, with_materials);
}

}  // namespace gibench
