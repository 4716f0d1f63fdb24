#include "common/scene/load.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/scene/find_file.h"
#include "common/scene/json_text.h"
#include "common/scene/light_kinds.h"
#include "common/scene/model_file.h"
#include "common/scene/names.h"
#include "common/scene/scene_parts.h"
#include "common/scene/scene_schema.h"

namespace gibench {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// "rooms/box.scene.json" → "box"; also for model files.
std::string name_of_file(const fs::path& file) {
  const fs::path stem = file.stem();
  return stem.extension() == ".scene" ? stem.stem().string() : stem.string();
}

/// The value of a key, or an empty list or object that stands for its absence.
const json& part_or(const json& document, const char* key, const json& absent) {
  const auto found = document.find(key);
  return found != document.end() ? *found : absent;
}

void read_document(const json& document, const JsonPlace& top, const fs::path& folder, Scene& scene) {
  const json no_list = json::array(), no_object = json::object();
  SceneBuilder builder(scene);
  for (const auto& [name, material] : part_or(document, "materials", no_object).items())
    scene.materials.push_back(read_material(material, name, top["materials"][name]));
  const json& objects = document["objects"];
  std::set<std::string> names;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const JsonPlace place = top["objects"][i];
    if (const auto name = objects[i]["name"].get<std::string>(); !names.insert(name).second)
      throw InputError(place["name"].text(), "there are two objects named " + in_quotes(name), "rename one of them");
    read_object(objects[i], place, folder, builder);
  }
  builder.finish_geometry(top["objects"].text());

  const json& lights = part_or(document, "lights", no_list);
  for (std::size_t i = 0; i < lights.size(); ++i)
    scene.lights.push_back(read_light(lights[i], top["lights"][i], folder, builder));
  read_cameras(part_or(document, "cameras", no_list), top["cameras"], builder);
  read_edits(part_or(document, "edits", no_list), lights, top["edits"], folder, builder);
  if (const auto exposure = document.find("exposure"); exposure != document.end())
    scene.exposure = read_exposure(*exposure, top["exposure"]);
}

/// One object for each material of each node of the model.
void add_model_objects(ModelFile& model, const std::string& place, SceneBuilder& builder) {
  Scene& scene = builder.scene();
  UniqueNames object_names, material_names;
  std::vector<std::optional<std::uint32_t>> material_index(model.materials.size());
  for (ModelPart& part : model.parts) {
    const ModelMaterial& source = model.materials[part.material];
    const std::string& material = source.material.name;
    std::optional<std::uint32_t>& index = material_index[part.material];
    if (!index) {
      index = static_cast<std::uint32_t>(scene.materials.size());
      scene.materials.push_back(source.material);
      scene.materials.back().name = material_names.take(material);
    }
    const std::string node = part.name.empty() ? scene.name : part.name;
    Object object;
    object.name = object_names.take(node == material || material == "default" ? node : node + "/" + material);
    object.material = *index;
    object.two_sided = source.two_sided;
    builder.add_object(std::move(object), std::move(part.geometry), place);
  }
}

Scene load_model_scene(const fs::path& file) {
  Scene scene;
  scene.name = name_of_file(file);
  SceneBuilder builder(scene);
  ModelFile model = read_model(file, file.string(), /*with_materials=*/true);
  add_model_objects(model, file.string(), builder);
  builder.finish_geometry(file.string());
  for (ModelLight& light : model.lights) {
    if (Vec3* position = parts_of(light.light).position) *position = builder.to_local(light.position);
    scene.lights.push_back(light.light);
  }
  for (ModelCamera& source : model.cameras) {
    source.camera.position = builder.to_local(source.position);
    source.camera.look_at = builder.to_local(source.look_at);
    scene.cameras.push_back(source.camera);
  }
  scene.warnings = std::move(model.warnings);
  return scene;
}

}  // namespace

Scene parse_scene(const std::string& json_text, const std::string& place, const fs::path& folder) {
  const json document = parse_json(json_text, place);
  const JsonPlace top(place);
  check_against_scene_schema(document, "", top);
  Scene scene;
  scene.name = document.value("name", name_of_file(place));
  read_document(document, top, folder, scene);
  return scene;
}

Scene load_scene(const fs::path& path) {
  const fs::path file = find_file(path, ".", path.string());
  Scene scene;
  if (file.extension() == ".json") {
    scene = parse_scene(read_file(file), file.string(), file.parent_path());
  } else if (is_model_name(file)) {
    scene = load_model_scene(file);
  } else {
    throw InputError(path.string(), "this is neither a scene file nor a model that Assimp reads",
                     "give a NAME.scene.json or an OBJ, PLY, glTF, STL or other model file");
  }
  scene.file = file;
  return scene;
}

}  // namespace gibench
