#include "common/scene_io/load.h"

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/scene_io/assimp/model_name.h"
#include "common/scene_io/models/model_scene.h"
#include "common/scene_io/native/scene_file.h"

namespace gibench {

Scene load_scene(const std::filesystem::path& path, const ModelReader& read_bare_model) {
  const std::filesystem::path file = find_file(path, ".", path.string());
  Scene scene;
  if (file.extension() == ".json") {
    scene = parse_scene(read_file(file), file.string(), file.parent_path());
  } else if (is_model_name(file)) {
    scene = load_model_scene(file, scene_name_of(file), read_bare_model);
  } else {
    throw InputError(path.string(), "this is neither a scene file nor a model that can be read",
                     "give a NAME.scene.json or an OBJ, PLY, glTF, STL or other model file");
  }
  scene.file = file;
  return scene;
}

}  // namespace gibench
