#include "common/scene_io/obj/obj_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/names.h"
#include "common/scene_io/model_parts/model_pictures.h"
#include "common/scene_io/model_parts/vertex_colours.h"
#include "common/scene_io/obj/mtl_material.h"
#include "common/scene_io/obj/mtl_text.h"
#include "common/scene_io/obj/obj_triangles.h"
#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;  // of a name that no file can have
  return fs::is_regular_file(path, ignored);
}

fs::path beside(const fs::path& file, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return file.parent_path() / name;
}

/// The MTL files that are there. `mtllib` names one with blanks in its name, or several; one that is not there may have the
/// name of the OBJ file.
std::vector<fs::path> library_files(const ObjText& obj, const fs::path& file, std::vector<std::string>& warnings) {
  std::vector<std::string> names;
  for (const std::string& line : obj.libraries) {
    std::string_view rest = line;
    if (is_file(beside(file, line))) names.push_back(line);
    else
      while (!rest.empty()) names.emplace_back(take_word(rest));
  }
  std::vector<fs::path> found;
  for (const std::string& name : names) {
    fs::path library = beside(file, name);
    if (!is_file(library)) {
      const fs::path of_same_name = fs::path(file).replace_extension(".mtl");
      const bool is_there = is_file(of_same_name);
      warnings.push_back("the material file " + in_quotes(name) + " does not exist" +
                         (is_there ? ", " + in_quotes(of_same_name.filename().string()) + " is read in its place" : ""));
      if (!is_there) continue;
      library = of_same_name;
    }
    if (std::find(found.begin(), found.end(), library) == found.end()) found.push_back(library);
  }
  return found;
}

std::vector<MtlMaterial> read_libraries(const std::vector<fs::path>& files, const ModelPlace& place,
                                        std::vector<std::string>& warnings) {
  std::vector<MtlMaterial> materials;
  for (const fs::path& file : files) {
    const MtlText mtl = parse_mtl(without_byte_order_mark(read_file(file), place.of_file(file)));
    const std::string name = file.filename().string();
    for (const std::string& warning : mtl.warnings) warnings.push_back(name + ": " + warning);
    if (!mtl.unknown_statements.empty())
      warnings.push_back(name + ": unknown statements are left out: " + few_of(mtl.unknown_statements));
    materials.insert(materials.end(), mtl.materials.begin(), mtl.materials.end());
  }
  return materials;
}

/// Triangles of the faces of a part in their picture; faces without texture points use none of it.
void add_use(const ObjText& obj, const ObjText::Part& part, PictureUse& use) {
  using Corner = ObjText::Corner;
  for_each_triangle(obj, part, [&](const Corner& a, const Corner& b, const Corner& c) {
    if (a.texture_point == ObjText::none || b.texture_point == ObjText::none || c.texture_point == ObjText::none) return;
    const auto& points = obj.texture_points;
    use.add({points[a.texture_point], points[b.texture_point], points[c.texture_point]}, obj.positions[a.position],
            obj.positions[b.position], obj.positions[c.position]);
  });
}

Rgb colour_of(const ObjText& obj, const ObjText::Part& part) {
  VertexColours colours;
  const auto corner = [&](const ObjText::Corner& c) {
    return VertexColours::Corner{obj.positions[c.position], obj.colours[c.position]};
  };
  for_each_triangle(obj, part,
                    [&](const auto& a, const auto& b, const auto& c) { colours.add(corner(a), corner(b), corner(c)); });
  return colours.mean();
}

class ObjMaterials {
 public:
  ObjMaterials(const ObjText& obj, const fs::path& file, Model& model)
      : obj_(obj), model_(model), shown_(file.filename().string()), pictures_(file.parent_path()) {}

  void read(const std::vector<MtlMaterial>& defined) {
    const std::vector<bool> is_used = uses_of_names();
    for (const MtlMaterial& material : defined)
      if (const auto name = index_of(material.name); name && is_used[*name]) add_defined(material, *name);
    leaves_out_colours_ = !index_.empty() && has_colours();
    for (std::uint32_t name = 0; name < obj_.material_names.size(); ++name)
      if (is_used[name] && !index_.contains(name)) undefined_.insert(in_quotes(obj_.material_names[name]));
    for (std::size_t p = 0; p < obj_.parts.size(); ++p) model_.parts[p].material = material_of_part(p);
    warn();
  }

 private:
  bool has_colours() const { return !obj_.colours.empty(); }

  std::vector<bool> uses_of_names() const {
    std::vector<bool> is_used(obj_.material_names.size(), false);
    for (const ObjText::Part& part : obj_.parts)
      if (part.material != ObjText::none) is_used[part.material] = true;
    return is_used;
  }

  std::optional<std::uint32_t> index_of(const std::string& name) const {
    const auto found = std::find(obj_.material_names.begin(), obj_.material_names.end(), name);
    if (found == obj_.material_names.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - obj_.material_names.begin());
  }

  void add_defined(const MtlMaterial& stated, std::uint32_t name) {
    if (index_.contains(name)) return;  // an earlier file defines it as well
    PictureUse use;
    if (stated.diffuse_picture || stated.specular_picture || stated.emission_picture)
      for (const ObjText::Part& part : obj_.parts)
        if (part.material == name) add_use(obj_, part, use);
    MaterialRemarks remarks;
    index_.emplace(name, model_.materials.size());
    model_.materials.push_back({material_of(stated, use, pictures_, remarks), false});
    remarks.warn(shown_, stated.name, model_.warnings);
  }

  std::size_t material_of_part(std::size_t part) {
    const std::uint32_t name = obj_.parts[part].material;
    if (const auto found = index_.find(name); found != index_.end()) return found->second;
    const std::size_t index = model_.materials.size();
    if (!has_colours()) index_.emplace(name, index);
    model_.materials.push_back(default_material());
    Material& made = model_.materials.back().material;
    if (name != ObjText::none) made.name = obj_.material_names[name];
    else has_no_name_ = true;
    if (has_colours()) made.diffuse = colour_remarks_.clamped(colour_of(obj_, obj_.parts[part]), 1.0F, "the colour of vertices");
    return index;
  }

  void warn() {
    const std::string used = has_colours() ? "the mean colour of the vertices is the albedo (taken as linear)"
                                           : fmt::format("diffuse with albedo {} is used", default_albedo);
    const auto warn = [&](const std::string& text) { model_.warnings.push_back(shown_ + ": " + text); };
    if (!undefined_.empty()) warn("materials that are defined nowhere: " + few_of(undefined_) + "; " + used);
    if (has_no_name_) warn("no material; " + used);
    if (leaves_out_colours_) warn("the colours of vertices that have a material are left out");
    colour_remarks_.warn(shown_, "default", model_.warnings);
  }

  const ObjText& obj_;
  Model& model_;
  std::string shown_;
  ModelPictures pictures_;
  MaterialRemarks colour_remarks_;
  std::map<std::uint32_t, std::size_t> index_;  // into the model's materials, by that into material_names
  std::set<std::string> undefined_;
  bool has_no_name_ = false, leaves_out_colours_ = false;
};

}  // namespace

void read_obj_materials(const ObjText& obj, const fs::path& file, const ModelPlace& place, Model& model) {
  std::vector<std::string> warnings;
  const std::vector<MtlMaterial> defined = read_libraries(library_files(obj, file, warnings), place, warnings);
  for (const std::string& warning : warnings) model.warnings.push_back(file.filename().string() + ": " + warning);
  ObjMaterials(obj, file, model).read(defined);
}

}  // namespace gibench
