#include "common/scene_io/native/read_edit.h"

#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/core/names.h"
#include "common/scene_io/native/read_light.h"
#include "common/scene_io/native/read_material.h"
#include "common/scene_io/native/read_values.h"
#include "common/scene_io/native/scene_schema.h"

namespace gibench {

namespace {

using nlohmann::json;

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& item : list) names.push_back(item.name);
  return names;
}

/// Reads edits in order; materials and lights are those that the edits so far have made.
class EditReader {
 public:
  EditReader(const json& lights, const std::filesystem::path& folder, SceneAssembler& assembler)
      : folder_(folder), assembler_(assembler), materials_(assembler.scene().materials), lights_(lights) {}

  SceneEdit read(const json& edit, const JsonPlace& place) {
    static_assert(std::variant_size_v<SceneEdit> == 4, "every kind of edit is read here");
    if (edit.contains("move"))
      return MoveEdit{object_name(edit["move"], place["move"]), vector_or(edit, "translate", Vec3d(0.0)),
                      vector_or(edit, "rotate_degrees", Vec3d(0.0))};
    if (edit.contains("material")) return read_material_edit(edit, place);
    if (edit.contains("light")) return read_light_edit(edit, place);
    return DeformEdit{object_name(edit["deform"], place["deform"]),
                      find_file(edit["file"].get<std::string>(), folder_, place["file"].text())};
  }

 private:
  std::string object_name(const json& value, const JsonPlace& place) const {
    auto name = value.get<std::string>();
    if (!has_object(assembler_.scene(), name))
      throw InputError(place.text(), "there is no object " + in_quotes(name),
                       known_names("objects", name, names_of(assembler_.scene().objects)));
    return name;
  }

  MaterialEdit read_material_edit(const json& edit, const JsonPlace& place) {
    const auto name = edit["material"].get<std::string>();
    for (Material& material : materials_)
      if (material.name == name) return {name, material = edited_material(edit, material, place)};
    throw InputError(place["material"].text(), "there is no material " + in_quotes(name),
                     known_names("materials", name, names_of(materials_)));
  }

  LightEdit read_light_edit(const json& edit, const JsonPlace& place) {
    const auto index = edit["light"].get<std::size_t>();
    if (index >= lights_.size())
      throw InputError(
          place["light"].text(), "there is no light " + std::to_string(index),
          lights_.empty() ? "the scene has no lights" : "write an index from 0 to " + std::to_string(lights_.size() - 1));
    json& light = lights_[index];
    // A radiance takes the place of a picture, and the other way round.
    if (edit.contains("radiance"))
      for (const char* key : {"file", "scale", "rotate_y_degrees"}) light.erase(key);
    if (edit.contains("file")) light.erase("radiance");
    light.update(edit);
    light.erase("light");
    check_against_scene_schema(light, "light", place);
    return {index, read_light(light, place, folder_, assembler_)};
  }

  const std::filesystem::path& folder_;
  SceneAssembler& assembler_;
  std::vector<Material> materials_;
  json lights_;
};

}  // namespace

void read_edits(const json& edits, const json& lights, const JsonPlace& place, const std::filesystem::path& folder,
                SceneAssembler& assembler) {
  EditReader reader(lights, folder, assembler);
  for (std::size_t i = 0; i < edits.size(); ++i) assembler.scene().edits.push_back(reader.read(edits[i], place[i]));
}

}  // namespace gibench
