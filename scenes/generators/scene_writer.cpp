#include "scenes/generators/scene_writer.h"

#include <fstream>
#include <utility>

#include "common/core/error.h"

namespace gibench::generators {

namespace {

std::string file_name(const std::string& text) {
  std::string name = text;
  for (char& letter : name)
    if (letter == ' ') letter = '-';
  return name;
}

}  // namespace

SceneWriter::SceneWriter(std::filesystem::path folder, std::string scene) : folder_(std::move(folder)), scene_(std::move(scene)) {
  std::error_code ignored;  // the writing below reports it
  std::filesystem::create_directories(folder_, ignored);
}

void SceneWriter::model(const std::string& name, const Mesh& mesh) {
  write_ply(mesh, folder_ / (scene_ + "-" + file_name(name) + ".ply"));
  triangles_of_[name] = mesh.triangle_count();
}

void SceneWriter::place(const std::string& name, const std::string& model, const std::string& material,
                        const Placement& placement) {
  const std::size_t number = ++objects_named_[name];
  const Vec3d &move = placement.translate, &scale = placement.scale;
  nlohmann::ordered_json object{{"name", number == 1 ? name : name + " " + std::to_string(number)},
                                {"material", material},
                                {"file", scene_ + "-" + file_name(model) + ".ply"}};
  if (scale != Vec3d(1.0)) object["scale"] = {scale.x, scale.y, scale.z};
  if (placement.turn_degrees != 0.0) object["rotate_degrees"] = {0.0, placement.turn_degrees, 0.0};
  object["translate"] = {move.x, move.y, move.z};
  if (placement.two_sided) object["two_sided"] = true;
  objects_.push_back(std::move(object));
  triangles_ += triangles_of_.at(model);
}

void SceneWriter::add(const std::string& name, const std::string& material, const Mesh& mesh, const Placement& placement) {
  model(name, mesh);
  place(name, name, material, placement);
}

std::size_t SceneWriter::write(const nlohmann::ordered_json& rest) const {
  nlohmann::ordered_json scene{{"gibench_scene", 1}, {"name", scene_}};
  scene.update(rest);
  scene["objects"] = objects_;
  const std::filesystem::path file = folder_ / (scene_ + ".scene.json");
  std::ofstream out(file);
  out << scene.dump(2) << '\n';
  out.close();
  if (!out) throw InputError(file.string(), "cannot be written", "name a folder that can be written");
  return triangles_;
}

}  // namespace gibench::generators
