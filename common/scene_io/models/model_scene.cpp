#include "common/scene_io/models/model_scene.h"

#include <optional>

#include "common/core/names.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

void place_light(Light& light, const Vec3& position) {
  if (Vec3* const place = parts_of(light).position) *place = position;
}

/// One object for each material of each node of the model.
void add_model_objects(Model& model, const std::string& place, SceneAssembler& assembler) {
  Scene& scene = assembler.scene();
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
    assembler.add_object(std::move(object), std::move(part.geometry), place);
  }
}

}  // namespace

Scene load_model_scene(const std::filesystem::path& file, const std::string& name, const ModelReader& read) {
  Scene scene;
  scene.name = name;
  SceneAssembler assembler(scene);
  Model model = read(file, file.string(), /*with_materials=*/true);
  add_model_objects(model, file.string(), assembler);
  assembler.finish_geometry(file.string());
  for (ModelLight& light : model.lights) {
    place_light(light.light, assembler.to_local(light.position));
    scene.lights.push_back(light.light);
  }
  for (ModelCamera& source : model.cameras) {
    assembler.place_camera(source.camera, source.position, source.look_at,
                           file.string() + ": camera " + in_quotes(source.camera.name));
    scene.cameras.push_back(source.camera);
  }
  scene.warnings = std::move(model.warnings);
  return scene;
}

}  // namespace gibench
