#include "common/scene_io/models/read_model.h"

#include "common/core/printable_text.h"
#include "common/scene_io/assimp/model_file.h"
#include "common/scene_io/assimp/model_name.h"
#include "common/scene_io/gltf/gltf_file.h"
#include "common/scene_io/obj/obj_model.h"
#include "common/scene_io/ply/ply_model.h"
#include "common/scene_io/stl/stl_model.h"

namespace gibench {

namespace {

/// Which reader of the project's own reads a file of this name; null: none.
Model (*own_reader(const std::filesystem::path& file))(const std::filesystem::path&, const std::string&, bool) {
  if (is_gltf_name(file)) return read_gltf;
  const std::string extension = extension_of(file);
  if (extension == ".obj") return read_obj;
  if (extension == ".ply") return read_ply;
  if (extension == ".stl") return read_stl;
  return nullptr;
}

/// Names of files may be in any encoding; those of scenes are printed and written as JSON.
void make_names_printable(Model& model) {
  for (ModelPart& part : model.parts) part.name = printable_text(part.name);
  for (ModelMaterial& material : model.materials) material.material.name = printable_text(material.material.name);
  for (ModelCamera& camera : model.cameras) camera.camera.name = printable_text(camera.camera.name);
  for (std::string& warning : model.warnings) warning = printable_text(warning);
}

}  // namespace

Model read_model(const std::filesystem::path& file, const std::string& place, bool with_materials) {
  const auto own = own_reader(file);
  Model model = own != nullptr ? own(file, place, with_materials) : read_with_assimp(file, place, with_materials);
  make_names_printable(model);
  return model;
}

bool is_read_by_assimp(const std::filesystem::path& file) { return own_reader(file) == nullptr && is_model_name(file); }

}  // namespace gibench
