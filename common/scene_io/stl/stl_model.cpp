#include "common/scene_io/stl/stl_model.h"

#include <fmt/format.h>

#include "common/core/atomic_file.h"
#include "common/scene/object_faces.h"
#include "common/scene_io/model_parts/equal_positions.h"
#include "common/scene_io/model_parts/material_remarks.h"
#include "common/scene_io/stl/stl_facets.h"

namespace gibench {

namespace {

/// Facets of fewer than three corners are counted in `left_out`.
ObjectGeometry geometry_of(const StlSolid& solid, const ModelPlace& place, std::size_t& left_out) {
  ObjectGeometry geometry;
  geometry.vertices = solid.corners;
  const std::vector<std::uint32_t> first = first_of_equal(solid.corners);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : solid.facet_ends) {
    const std::span<const std::uint32_t> corners(first.data() + begin, end - begin);
    begin = end;
    if (corners.size() > most_corners) place.refuse("has a facet of more than 10 000 corners", "export it again");
    if (corners.size() < 3) ++left_out;
    else add_face(corners, geometry);
  }
  return geometry;
}

}  // namespace

Model read_stl(const std::filesystem::path& file, const std::string& place_text, bool with_materials) {
  const ModelPlace place(file, place_text);
  const StlFacets facets = parse_stl(read_file(file), place);
  const std::string shown = file.filename().string();
  Model model;
  std::size_t left_out = 0;
  for (const StlSolid& solid : facets.solids)
    if (ObjectGeometry geometry = geometry_of(solid, place, left_out); !geometry.faces.empty())
      model.parts.push_back({solid.name, 0, std::move(geometry)});
  if (model.parts.empty()) place.refuse("has no faces", "use a model with surfaces");
  model.materials.push_back(default_material());
  for (const std::string& warning : facets.warnings) model.warnings.push_back(shown + ": " + warning);
  if (left_out > 0)
    model.warnings.push_back(fmt::format("{}: {} facets of fewer than three corners are left out", shown, left_out));
  if (with_materials)
    model.warnings.push_back(fmt::format("{}: no material; diffuse with albedo {} is used", shown, default_albedo));
  return model;
}

}  // namespace gibench
