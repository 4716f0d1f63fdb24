#include "common/scene_io/native/read_object.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/core/names.h"
#include "common/scene/transform.h"
#include "common/scene_io/models/read_model.h"
#include "common/scene_io/native/read_values.h"

namespace gibench {

namespace {

using nlohmann::json;

Transform read_transform(const json& object, const JsonPlace& place) {
  const Vec3d scale = object.contains("scale") ? read_triple(object["scale"]) : Vec3d(1.0);
  if (scale.x == 0.0 || scale.y == 0.0 || scale.z == 0.0)
    throw InputError(place["scale"].text(), "a scale of 0 leaves nothing", "give factors other than 0");
  return make_transform(scale, vector_or(object, "rotate_degrees", Vec3d(0.0)), vector_or(object, "translate", Vec3d(0.0)));
}

ObjectGeometry read_inline_geometry(const json& object, const JsonPlace& place) {
  ObjectGeometry geometry;
  const json& vertices = object["vertices"];
  geometry.vertices.reserve(vertices.size());
  for (const json& vertex : vertices) geometry.vertices.push_back(read_vector(vertex));
  const json& faces = object["faces"];
  geometry.faces.reserve(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Face face;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t corner = std::min(i, faces[f].size() - 1);
      const auto index = faces[f][corner].get<std::uint64_t>();
      if (index >= vertices.size())
        throw InputError(
            place["faces"][f][corner].text(),
            "index " + std::to_string(index) + " is past the end of " + std::to_string(vertices.size()) + " vertices",
            "write an index from 0 to " + std::to_string(vertices.size() - 1));
      face.corners[i] = static_cast<std::uint32_t>(index);
    }
    geometry.faces.push_back(face);
  }
  return geometry;
}

std::uint32_t find_material(const Scene& scene, const std::string& name, const JsonPlace& place) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) {
    if (material.name == name) return static_cast<std::uint32_t>(names.size());
    names.push_back(material.name);
  }
  throw InputError(place.text(), "there is no material " + in_quotes(name), known_names("materials", name, names));
}

void check_name_is_new(const Scene& scene, const std::string& name, const JsonPlace& place) {
  for (const Object& object : scene.objects)
    if (object.name == name)
      throw InputError(place["name"].text(), "there are two objects named " + in_quotes(name), "rename one of them");
}

void read_file_object(const json& value, Object object, const JsonPlace& place, const std::filesystem::path& folder,
                      SceneAssembler& assembler) {
  const JsonPlace file_place = place["file"];
  const auto file = find_file(value["file"].get<std::string>(), folder, file_place.text());
  const bool own_materials = !value.contains("material");
  const Transform transform = read_transform(value, place);
  Model model = read_model(file, file_place.text(), own_materials);
  Scene& scene = assembler.scene();
  for (const std::string& warning : model.warnings) scene.warnings.push_back("object " + in_quotes(object.name) + ": " + warning);
  if (!model.lights.empty() || !model.cameras.empty())
    scene.warnings.push_back("object " + in_quotes(object.name) + ": the lights and cameras of its file are left out");

  std::vector<ObjectGeometry> by_material(own_materials ? model.materials.size() : 1);
  for (ModelPart& part : model.parts) {
    transform_geometry(transform, part.geometry);
    by_material[own_materials ? part.material : 0].append(part.geometry);
  }
  if (!own_materials) return assembler.add_object(std::move(object), std::move(by_material[0]), file_place.text());
  UniqueNames names;
  for (const Material& material : scene.materials) names.take(material.name);
  for (std::size_t m = 0; m < by_material.size(); ++m) {
    if (by_material[m].faces.empty()) continue;
    Material material = model.materials[m].material;
    material.name = names.take(object.name + "/" + material.name);
    Object part = object;
    part.name = material.name;
    check_name_is_new(scene, part.name, place);
    part.material = static_cast<std::uint32_t>(scene.materials.size());
    part.two_sided = value.value("two_sided", model.materials[m].two_sided);
    scene.materials.push_back(std::move(material));
    assembler.add_object(std::move(part), std::move(by_material[m]), file_place.text());
  }
}

}  // namespace

void read_object(const json& value, const JsonPlace& place, const std::filesystem::path& folder, SceneAssembler& assembler) {
  Object object;
  object.name = value["name"].get<std::string>();
  object.two_sided = value.value("two_sided", false);
  object.group = value.value("group", std::string());
  check_name_is_new(assembler.scene(), object.name, place);
  if (const auto material = value.find("material"); material != value.end())
    object.material = find_material(assembler.scene(), material->get<std::string>(), place["material"]);
  if (value.contains("file")) return read_file_object(value, std::move(object), place, folder, assembler);
  ObjectGeometry geometry = read_inline_geometry(value, place);
  const std::size_t given = geometry.vertices.size();
  transform_geometry(read_transform(value, place), geometry);
  assembler.add_object(std::move(object), std::move(geometry), place.text());
  const Object& added = assembler.scene().objects.back();
  if (const std::size_t unused = given - (added.vertex_end - added.vertex_begin); unused > 0)
    assembler.scene().warnings.push_back("object " + in_quotes(added.name) + ": " + std::to_string(unused) +
                                         " vertices belong to no face and are left out");
}

}  // namespace gibench
