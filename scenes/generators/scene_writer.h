/// A scene file under construction: models as PLY files beside it, objects that place them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "scenes/generators/mesh.h"

namespace gibench::generators {

/// Where and how a model stands in the scene.
struct Placement {
  Vec3d translate = Vec3d(0.0);  ///< metres
  double turn_degrees = 0.0;     ///< about y
  Vec3d scale = Vec3d(1.0);
  bool two_sided = false;
};

/// Writes `NAME.scene.json` and its models, which are called `NAME-MODEL.ply`.
class SceneWriter {
 public:
  /// Makes `folder` where it is missing.
  SceneWriter(std::filesystem::path folder, std::string scene);

  /// Writes the model; place() puts it into the scene as often as wanted. Throws InputError where it cannot be written.
  void model(const std::string& name, const Mesh& mesh);
  /// Puts an object into the scene; `name` gets a number where an object has that name already.
  void place(const std::string& name, const std::string& model, const std::string& material, const Placement& placement = {});
  /// A model that is placed once, under its own name.
  void add(const std::string& name, const std::string& material, const Mesh& mesh, const Placement& placement = {});

  /// Writes the scene file: `rest` with the scene's name in front and the objects. Returns the number of triangles.
  std::size_t write(const nlohmann::ordered_json& rest) const;
  std::size_t objects() const { return objects_.size(); }
  bool has_model(const std::string& name) const { return triangles_of_.contains(name); }

 private:
  std::filesystem::path folder_;
  std::string scene_;
  nlohmann::ordered_json objects_ = nlohmann::ordered_json::array();
  std::map<std::string, std::size_t> triangles_of_, objects_named_;
  std::size_t triangles_ = 0;
};

}  // namespace gibench::generators
