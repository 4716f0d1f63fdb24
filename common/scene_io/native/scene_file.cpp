#include "common/scene_io/native/scene_file.h"

#include <nlohmann/json.hpp>
#include <set>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/json/json_text.h"
#include "common/scene_io/native/read_camera.h"
#include "common/scene_io/native/read_edit.h"
#include "common/scene_io/native/read_light.h"
#include "common/scene_io/native/read_material.h"
#include "common/scene_io/native/read_object.h"
#include "common/scene_io/native/read_values.h"
#include "common/scene_io/native/scene_schema.h"

namespace gibench {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// The value of a key, or an empty list or object that stands for its absence.
const json& part_or(const json& document, const char* key, const json& absent) {
  const auto found = document.find(key);
  return found != document.end() ? *found : absent;
}

void read_document(const json& document, const JsonPlace& top, const fs::path& folder, Scene& scene) {
  const json no_list = json::array(), no_object = json::object();
  SceneAssembler assembler(scene);
  for (const auto& [name, material] : part_or(document, "materials", no_object).items())
    scene.materials.push_back(read_material(material, name, top["materials"][name]));
  const json& objects = document["objects"];
  std::set<std::string> names;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const JsonPlace place = top["objects"][i];
    if (const auto name = objects[i]["name"].get<std::string>(); !names.insert(name).second)
      throw InputError(place["name"].text(), "there are two objects named " + in_quotes(name), "rename one of them");
    read_object(objects[i], place, folder, assembler);
  }
  assembler.finish_geometry(top["objects"].text());

  const json& lights = part_or(document, "lights", no_list);
  for (std::size_t i = 0; i < lights.size(); ++i)
    scene.lights.push_back(read_light(lights[i], top["lights"][i], folder, assembler));
  read_cameras(part_or(document, "cameras", no_list), top["cameras"], assembler);
  read_edits(part_or(document, "edits", no_list), lights, top["edits"], folder, assembler);
  if (const auto exposure = document.find("exposure"); exposure != document.end())
    scene.exposure = read_exposure(*exposure, top["exposure"]);
}

}  // namespace

Scene parse_scene(const std::string& json_text, const std::string& place, const fs::path& folder) {
  const json document = parse_json(json_text, place);
  const JsonPlace top(place);
  check_against_scene_schema(document, "", top);
  Scene scene;
  scene.name = document.value("name", scene_name_of(place));
  read_document(document, top, folder, scene);
  return scene;
}

std::string scene_name_of(const fs::path& file) {
  const fs::path stem = file.stem();
  return stem.extension() == ".scene" ? stem.stem().string() : stem.string();
}

}  // namespace gibench
