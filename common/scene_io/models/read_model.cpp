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

Model read(const std::filesystem::path& file, const std::string& place, bool with_materials) {
  if (is_gltf_name(file)) return read_gltf(file, place, with_materials);
  const std::string extension = extension_of(file);
  if (extension == ".obj") return read_obj(file, place, with_materials);
  if (extension == ".ply") return read_ply(file, place, with_materials);
  if (extension == ".stl") return read_stl(file, place, with_materials);
  return read_with_assimp(file, place, with_materials);
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
  Model model = read(file, place, with_materials);
  make_names_printable(model);
  return model;
}

}  // namespace gibench
