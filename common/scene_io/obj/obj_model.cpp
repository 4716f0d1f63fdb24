#include "common/scene_io/obj/obj_model.h"

#include <algorithm>

#include "common/core/atomic_file.h"
#include "common/scene/object_faces.h"
#include "common/scene_io/model_parts/equal_positions.h"
#include "common/scene_io/model_parts/material_remarks.h"
#include "common/scene_io/obj/obj_materials.h"
#include "common/scene_io/obj/obj_text.h"
#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

/// Gives parts their geometry; keeps, for each vertex of the file, the one that it became in the part of the moment.
class ObjMeshes {
 public:
  ObjMeshes(const ObjText& obj, const ModelPlace& place)
      : obj_(obj), place_(place), first_(first_of_equal(obj.positions)), local_(obj.positions.size(), ObjText::none) {}

  ObjectGeometry geometry(const ObjText::Part& part) {
    ObjectGeometry geometry;
    geometry.faces.reserve(part.face_ends.size());
    global_.clear();
    std::vector<std::uint32_t> face;
    std::size_t begin = 0;
    for (const std::uint32_t end : part.face_ends) {
      face.clear();
      for (std::size_t c = begin; c < end; ++c) face.push_back(local_vertex(part.corners[c].position, geometry));
      if (face.size() > most_corners)
        place_.refuse("has a face of " + std::to_string(face.size()) + " corners", "divide it into faces of at most 10 000");
      add_face(face, geometry);
      begin = end;
    }
    for (const std::uint32_t vertex : global_) local_[first_[vertex]] = ObjText::none;
    return geometry;
  }

 private:
  std::uint32_t local_vertex(std::uint32_t vertex, ObjectGeometry& geometry) {
    std::uint32_t& local = local_[first_[vertex]];
    if (local == ObjText::none) {
      local = static_cast<std::uint32_t>(geometry.vertices.size());
      geometry.vertices.push_back(obj_.positions[vertex]);
      global_.push_back(vertex);
    }
    return local;
  }

  const ObjText& obj_;
  const ModelPlace& place_;
  std::vector<std::uint32_t> first_, local_, global_;
};

void warn_of_statements(const ObjText& obj, const std::string& shown, std::vector<std::string>& warnings) {
  if (obj.points_and_lines > 0) warnings.push_back(std::to_string(obj.points_and_lines) + " points and lines are left out");
  if (!obj.unknown_statements.empty())
    warnings.push_back(shown + ": unknown statements are left out: " + few_of(obj.unknown_statements));
  if (obj.has_weights) warnings.push_back(shown + ": the weights of vertices (a fourth number) are left out");
}

}  // namespace

Model read_obj(const std::filesystem::path& file, const std::string& place_text, bool with_materials) {
  const ModelPlace place(file, place_text);
  ObjText obj = parse_obj(without_byte_order_mark(read_file(file), place), place);
  if (obj.parts.empty()) place.refuse("has no faces", "use a model with surfaces");
  std::stable_sort(obj.parts.begin(), obj.parts.end(),
                   [](const ObjText::Part& a, const ObjText::Part& b) { return a.object < b.object; });
  Model model;
  const std::string shown = file.filename().string();
  warn_of_statements(obj, shown, model.warnings);
  ObjMeshes meshes(obj, place);
  for (const ObjText::Part& part : obj.parts) model.parts.push_back({obj.object_names[part.object], 0, meshes.geometry(part)});
  if (!with_materials) {
    model.materials.push_back(default_material());
    return model;
  }
  if (obj.colours_are_partial) model.warnings.push_back(shown + ": some vertices have a colour; colours are left out");
  read_obj_materials(obj, file, place, model);
  return model;
}

}  // namespace gibench
