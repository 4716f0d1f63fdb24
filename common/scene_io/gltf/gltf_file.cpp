#include "common/scene_io/gltf/gltf_file.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/gltf/cameras.h"
#include "common/scene_io/gltf/extensions.h"
#include "common/scene_io/gltf/lights.h"
#include "common/scene_io/gltf/materials.h"
#include "common/scene_io/gltf/nodes.h"
#include "common/scene_io/gltf/primitive.h"

namespace gibench {

namespace {

/// The primitives of meshes with the materials that they wear, each read once.
class MeshReader {
 public:
  MeshReader(GltfDocument& document, bool with_materials, Model& model)
      : document_(document), materials_(document, model), with_materials_(with_materials), model_(model) {
    if (!with_materials) model.materials.emplace_back();
  }

  void add(const GltfNode& node) {
    const auto index = node.value.whole_number_if("mesh");
    if (!index) return;
    const GltfValue mesh = document_.item("meshes", *index);
    const std::string name = node.value.text_or("name", mesh.text_or("name", ""));
    if (node.value.has("skin")) is_skinned_ = true;
    if (node.value.has("weights")) return add_parts(read(mesh, node.value), name, node.to_file);  // a shape of this node alone
    auto known = known_.find(*index);
    if (known == known_.end()) known = known_.emplace(*index, read(mesh, mesh)).first;
    add_parts(known->second, name, node.to_file);
  }

  void warn() const {
    if (with_materials_) materials_.warn();
  }
  std::size_t left_out() const { return left_out_; }
  bool is_skinned() const { return is_skinned_; }

 private:
  struct Worn {
    ObjectGeometry geometry;
    std::size_t material;
  };

  static std::vector<double> weights_of(const GltfValue& owner) {
    std::vector<double> weights;
    const auto list = owner.find("weights");
    for (std::size_t i = 0; list && i < list->size(); ++i) weights.push_back(list->at(i).number());
    return weights;
  }

  std::vector<Worn> read(const GltfValue& mesh, const GltfValue& owner_of_weights) {
    std::vector<Worn> worn;
    const std::vector<double> weights = weights_of(owner_of_weights);
    const GltfValue primitives = mesh.at("primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const GltfPrimitive primitive = read_primitive(document_, primitives.at(p), weights);
      if (!primitive.is_surface) ++left_out_;
      if (primitive.triangles.empty()) continue;
      worn.push_back({geometry_of(primitive), with_materials_ ? materials_.of(primitive) : 0});
    }
    return worn;
  }

  void add_parts(const std::vector<Worn>& worn, const std::string& name, const Transform& to_file) {
    for (const Worn& one : worn) {
      ObjectGeometry geometry = one.geometry;
      transform_geometry(to_file, geometry);
      model_.parts.push_back({name, one.material, std::move(geometry)});
    }
  }

  GltfDocument& document_;
  GltfMaterials materials_;
  bool with_materials_;
  Model& model_;
  std::map<std::size_t, std::vector<Worn>> known_;  ///< by mesh
  std::size_t left_out_ = 0;                        ///< primitives of points and lines
  bool is_skinned_ = false;
};

/// One warning that names everything of the file that was not used.
void warn_of_the_rest(const GltfDocument& document, const MeshReader& meshes, Model& model) {
  std::vector<std::string> names;
  for (const std::string& name : unsupported_gltf_extensions(document.root().json())) names.push_back(name);
  if (meshes.left_out() > 0) names.push_back(std::to_string(meshes.left_out()) + " primitives of points and lines");
  if (meshes.is_skinned()) names.emplace_back("skins (meshes stand as their nodes put them)");
  if (document.count("animations") > 0) names.emplace_back("animations");
  if (document.count("scenes") > 1) names.emplace_back("scenes but the default one");
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  if (!text.empty()) model.warnings.push_back(document.file().filename().string() + ": not used: " + text);
}

}  // namespace

bool is_gltf_name(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".gltf" || extension == ".glb";
}

Model read_gltf(const std::filesystem::path& file, const std::string& place, bool with_materials) {
  GltfDocument document(file, place);
  Model model;
  MeshReader meshes(document, with_materials, model);
  UniqueNames camera_names;
  for (const GltfNode& node : scene_nodes(document)) {
    meshes.add(node);
    add_gltf_light(document, node, model);
    add_gltf_camera(document, node, camera_names, model);
  }
  if (model.parts.empty())
    throw InputError(place, "the model file " + in_quotes(file.string()) + " has no faces", "use a model with surfaces");
  meshes.warn();
  warn_of_the_rest(document, meshes, model);
  return model;
}

}  // namespace gibench
