#include "common/scene_io/assimp/model_file.h"

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <mutex>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/assimp/assimp_nodes.h"
#include "common/scene_io/assimp/model_lights.h"
#include "common/scene_io/assimp/model_materials.h"
#include "common/scene_io/assimp/model_meshes.h"
#include "common/scene_io/assimp/model_name.h"
#include "common/scene_io/assimp/model_units.h"
#include "common/scene_io/assimp/single_precision.h"

namespace gibench {

namespace {

/// Collects what Assimp says while a file is read; its log is one for the whole process.
class AssimpLog {
 public:
  AssimpLog() : lock_(mutex()) {
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Collector(lines_), Assimp::Logger::Warn | Assimp::Logger::Err);
  }
  ~AssimpLog() { Assimp::DefaultLogger::kill(); }
  AssimpLog(const AssimpLog&) = delete;
  AssimpLog& operator=(const AssimpLog&) = delete;

  /// The first line that contains `text`, without Assimp's prefix; empty where none does.
  std::string line_with(std::string_view text) const {
    for (const std::string& line : lines_)
      if (const auto at = line.find(text); at != std::string::npos)
        return line.substr(at, line.find_last_not_of("\r\n") + 1 - at);
    return {};
  }

 private:
  class Collector : public Assimp::LogStream {
   public:
    explicit Collector(std::vector<std::string>& lines) : lines_(lines) {}
    void write(const char* message) override { lines_.emplace_back(message); }

   private:
    std::vector<std::string>& lines_;
  };

  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }

  std::lock_guard<std::mutex> lock_;
  std::vector<std::string> lines_;
};

/// Calls visit(node) for a node and all below it, parents first.
template <class Visit>
void for_each_node(const aiNode& node, const Visit& visit) {
  visit(node);
  for (unsigned i = 0; i < node.mNumChildren; ++i) for_each_node(*node.mChildren[i], visit);
}

void add_parts(const aiScene& scene, const std::vector<ObjectGeometry>& meshes, const std::string& shown, Model& model) {
  LostPrecision lost;
  for (const ObjectGeometry& mesh : meshes) lost.add(mesh);
  for_each_node(*scene.mRootNode, [&](const aiNode& node) {
    const Transform transform = transform_of(node);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
      ObjectGeometry geometry = meshes[node.mMeshes[i]];
      if (geometry.faces.empty()) continue;
      transform_geometry(transform, geometry);
      const aiString& name = node.mParent != nullptr ? node.mName : mesh.mName;
      model.parts.push_back({name.C_Str(), mesh.mMaterialIndex, std::move(geometry)});
    }
  });
  lost.warn(shown, model.warnings);
}

bool has_vertex_colours(const aiScene& scene) {
  return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                     [](const aiMesh* mesh) { return mesh->HasVertexColors(0); });
}

}  // namespace

Model read_with_assimp(const std::filesystem::path& file, const std::string& place, bool with_materials) {
  const std::string shown = in_quotes(file.string());
  if (!is_model_name(file))
    throw InputError(place, shown + " is not a model file that Assimp reads", "use OBJ, PLY, glTF, STL or another model format");
  const AssimpLog log;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (!log.line_with("out-of-range indices").empty())  // else Assimp leaves such faces out
    throw InputError(place, "the model file " + shown + " has a face with a vertex index out of range", "export it again");
  if (scene == nullptr)
    throw InputError(place, "the model file " + shown + " cannot be read: " + importer.GetErrorString(),
                     "export it again, or as OBJ, PLY or glTF");

  Model model;
  const std::vector<ObjectGeometry> meshes = read_meshes(*scene, place, model.warnings);
  add_parts(*scene, meshes, file.filename().string(), model);
  if (model.parts.empty()) throw InputError(place, "the model file " + shown + " has no faces", "use a model with surfaces");
  std::vector<bool> used(scene->mNumMaterials, false);
  for (const ModelPart& part : model.parts) used[part.material] = with_materials;
  read_model_materials(*scene, file, used, model);
  read_model_lights(*scene, model);
  read_model_cameras(*scene, model);
  if (with_materials && has_vertex_colours(*scene))
    model.warnings.push_back(file.filename().string() + ": the colours of its vertices are left out");
  convert_units(*scene, file, model);
  return model;
}

}  // namespace gibench
