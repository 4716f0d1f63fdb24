#include "common/scene_io/ply/ply_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "common/core/atomic_file.h"
#include "common/core/names.h"
#include "common/scene/object_faces.h"
#include "common/scene_io/model_parts/material_remarks.h"
#include "common/scene_io/model_parts/vertex_colours.h"
#include "common/scene_io/ply/ply_records.h"
#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

/// Index of the first property of one of these names; the number of properties where there is none.
std::size_t index_of(const PlyElement& element, std::initializer_list<std::string_view> names) {
  const auto is_named = [&](const PlyProperty& property) {
    return std::find(names.begin(), names.end(), property.name) != names.end();
  };
  return static_cast<std::size_t>(std::find_if(element.properties.begin(), element.properties.end(), is_named) -
                                  element.properties.begin());
}

/// What 1 is in a colour of this type: the largest integer, or 1.
double full_scale(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 255.0;
    case PlyType::int16:
    case PlyType::uint16: return 65535.0;
    case PlyType::int32:
    case PlyType::uint32: return 4294967295.0;
    case PlyType::float32:
    case PlyType::float64: return 1.0;
  }
  return 1.0;
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::filesystem::path& file, const ModelPlace& place)
      : header_(parse_ply_header(bytes, place)),
        records_(bytes, header_, place),
        place_(place),
        shown_(file.filename().string()) {}

  Model read(bool with_materials) {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty() || element.count == 0) continue;
      if (element.name == "vertex") read_vertices(element);
      else if (element.name == "face") read_faces(element);
      else if (element.name == "tristrips") read_strips(element);
      else skip(element);
    }
    if (geometry_.faces.empty()) place_.refuse("has no faces", "use a model with surfaces");
    warn_of_the_rest(with_materials);
    model_.materials.push_back(default_material());
    if (with_materials) set_colour();
    model_.parts.push_back({"", 0, std::move(geometry_)});
    return std::move(model_);
  }

 private:
  void warn(const std::string& text) { model_.warnings.push_back(shown_ + ": " + text); }

  void read_vertices(const PlyElement& element) {
    if (!geometry_.vertices.empty()) place_.refuse("has two elements \"vertex\"", "export it again");
    const std::array<std::size_t, 3> position{index_of(element, {"x"}), index_of(element, {"y"}), index_of(element, {"z"})};
    const std::array<std::size_t, 3> colour{index_of(element, {"red", "diffuse_red", "r"}),
                                            index_of(element, {"green", "diffuse_green", "g"}),
                                            index_of(element, {"blue", "diffuse_blue", "b"})};
    const auto is_there = [&](std::size_t p) { return p < element.properties.size() && !element.properties[p].count_type; };
    if (!std::all_of(position.begin(), position.end(), is_there))
      place_.refuse("has vertices without x, y and z", "export it again");
    const bool is_coloured = std::all_of(colour.begin(), colour.end(), is_there);
    PlyRecord record;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      records_.read(element, i, record);
      geometry_.vertices.emplace_back(record.numbers[position[0]], record.numbers[position[1]], record.numbers[position[2]]);
      if (!is_coloured) continue;
      Vec3d value;
      for (int c = 0; c < 3; ++c) {
        const std::size_t p = colour[static_cast<std::size_t>(c)];
        value[c] = record.numbers[p] / full_scale(element.properties[p].type);
      }
      colours_.emplace_back(value);
    }
    has_texture_points_ = has_texture_points_ || index_of(element, {"s", "u", "texture_u"}) < element.properties.size();
  }

  /// The list of vertex indices, which readers know by two names.
  std::size_t list_of_indices(const PlyElement& element) const {
    const std::size_t list = index_of(element, {"vertex_indices", "vertex_index"});
    if (list < element.properties.size() && element.properties[list].count_type) return list;
    place_.refuse("has no list vertex_indices in its element " + excerpt(element.name), "export it again");
  }

  std::uint32_t vertex(double index, std::uint64_t face) const {
    if (index >= 0.0 && index < static_cast<double>(geometry_.vertices.size())) return static_cast<std::uint32_t>(index);
    place_.refuse(fmt::format("has a face out of range: face {} has vertex index {:.0f}, and there are {} vertices", face, index,
                              geometry_.vertices.size()),
                  "correct the index or export the file again");
  }

  void read_faces(const PlyElement& element) {
    const std::size_t list = list_of_indices(element);
    PlyRecord record;
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < element.count; ++f) {
      records_.read(element, f, record);
      corners.clear();
      for (const double index : record.lists[list]) corners.push_back(vertex(index, f));
      if (corners.size() > most_corners)
        place_.refuse(fmt::format("has a face of {} corners", corners.size()), "divide it into faces of at most 10 000");
      if (corners.size() < 3) ++points_and_lines_;
      else add_face(corners, geometry_);
    }
    if (index_of(element, {"texcoord"}) < element.properties.size()) has_texture_points_ = true;
    if (index_of(element, {"red", "diffuse_red", "r"}) < element.properties.size()) has_face_colours_ = true;
  }

  /// Strips of triangles: each index after the second makes one with the two before it, which turn the other way every
  /// second time; −1 begins a new strip.
  void read_strips(const PlyElement& element) {
    const std::size_t list = list_of_indices(element);
    PlyRecord record;
    std::vector<std::uint32_t> strip;
    for (std::uint64_t s = 0; s < element.count; ++s) {
      records_.read(element, s, record);
      strip.clear();
      for (const double index : record.lists[list]) {
        if (index == -1.0) {
          strip.clear();
          continue;
        }
        strip.push_back(vertex(index, s));
        if (const std::size_t n = strip.size(); n >= 3) {
          const bool is_turned = n % 2 == 0;
          const std::uint32_t a = strip[n - 3], b = strip[n - 2], c = strip[n - 1];
          geometry_.faces.push_back(is_turned ? Face{{b, a, c, c}} : Face{{a, b, c, c}});
        }
      }
    }
  }

  void skip(const PlyElement& element) {
    PlyRecord record;
    for (std::uint64_t i = 0; i < element.count; ++i) records_.read(element, i, record);
    left_out_.insert(excerpt(element.name));
  }

  void warn_of_the_rest(bool with_materials) {
    if (points_and_lines_ > 0) warn(fmt::format("{} points and lines are left out", points_and_lines_));
    if (!left_out_.empty()) warn("elements that are left out: " + few_of(left_out_));
    if (const std::size_t bytes = records_.bytes_left(); bytes > 0)
      warn(fmt::format("{} bytes after the last element are left out", bytes));
    if (with_materials && !header_.picture.empty()) warn("its picture " + in_quotes(header_.picture) + " is not used");
    else if (with_materials && has_texture_points_) warn("its texture points are not used");
    if (with_materials && has_face_colours_) warn("the colours of its faces are left out");
  }

  void set_colour() {
    if (colours_.empty()) return warn(fmt::format("no material; diffuse with albedo {} is used", default_albedo));
    MaterialRemarks remarks;
    Material& material = model_.materials[0].material;
    material.diffuse = remarks.clamped(mean_colour(), 1.0F, "the colour of vertices");
    warn("the mean colour of the vertices is the albedo (taken as linear)");
    remarks.warn(shown_, material.name, model_.warnings);
  }

  Rgb mean_colour() const {
    VertexColours mean;
    const auto corner = [&](std::uint32_t vertex) { return VertexColours::Corner{geometry_.vertices[vertex], colours_[vertex]}; };
    for (const Face& face : geometry_.faces) {
      const auto& [a, b, c, d] = face.corners;
      mean.add(corner(a), corner(b), corner(c));
      if (face.is_quad()) mean.add(corner(a), corner(c), corner(d));
    }
    return mean.mean();
  }

  PlyHeader header_;
  PlyRecords records_;
  const ModelPlace& place_;
  std::string shown_;
  Model model_;
  ObjectGeometry geometry_;
  std::vector<Vec3> colours_;
  std::set<std::string> left_out_;
  std::size_t points_and_lines_ = 0;
  bool has_texture_points_ = false, has_face_colours_ = false;
};

}  // namespace

Model read_ply(const std::filesystem::path& file, const std::string& place_text, bool with_materials) {
  const ModelPlace place(file, place_text);
  const std::string bytes = read_file(file);
  return PlyReader(without_byte_order_mark(bytes, place), file, place).read(with_materials);
}

}  // namespace gibench
