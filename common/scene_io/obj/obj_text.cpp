#include "common/scene_io/obj/obj_text.h"

#include <array>
#include <charconv>
#include <map>
#include <unordered_map>

#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

/// Statements that change nothing of the surface's shape: normals, smoothing, and how a renderer is to show it.
const std::set<std::string, std::less<>> statements_without_effect{
    "vn", "s", "mg", "lod", "bevel", "c_interp", "vp", "d_interp", "usemap", "maplib", "shadow_obj", "trace_obj"};

class ObjParser {
 public:
  ObjParser(std::string_view text, const ModelPlace& place) : lines_(text), place_(place) {}

  ObjText run() {
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view keyword = take_word(rest);
      if (keyword == "v") read_position(rest);
      else if (keyword == "vt") read_texture_point(rest);
      else if (keyword == "f" || keyword == "fo") read_face(rest);
      else read_other(keyword, rest);
    }
    finish();
    return std::move(obj_);
  }

 private:
  /// Takes numbers to the end of the line, or to a comment on it; returns how many there were, at most `most`.
  template <std::size_t most>
  std::size_t read_numbers(std::string_view rest, std::array<double, most>& numbers) {
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
      const auto number = to_number(word);
      if (!number) place_.refuse_line(lines_.number(), excerpt(word) + " is not a number");
      if (count == most) place_.refuse_line(lines_.number(), "more than " + std::to_string(most) + " numbers");
      numbers[count++] = *number;
    }
    return count;
  }

  [[noreturn]] void refuse_short_line(const std::string& problem) const {
    if (lines_.is_unended()) place_.refuse_cut_short("its last line is " + excerpt(lines_.line()));
    place_.refuse_line(lines_.number(), problem);
  }

  /// x y z, with a weight of rational curves (4 numbers) or a colour (6, with its opacity 7).
  void read_position(std::string_view rest) {
    std::array<double, 7> n{};
    const std::size_t count = read_numbers(rest, n);
    if (count < 3) refuse_short_line("a vertex of " + std::to_string(count) + " numbers");
    if (count == 5) place_.refuse_line(lines_.number(), "a vertex of 5 numbers: neither x y z w nor x y z r g b");
    if (count == 4 && n[3] != 1.0) obj_.has_weights = true;
    if (count >= 6) {
      obj_.colours.resize(obj_.positions.size(), Vec3(0.0F));
      obj_.colours.emplace_back(n[3], n[4], n[5]);
      ++coloured_;
    }
    obj_.positions.emplace_back(n[0], n[1], n[2]);
  }

  void read_texture_point(std::string_view rest) {
    std::array<double, 3> n{};
    if (read_numbers(rest, n) == 0) refuse_short_line("a texture point without numbers");
    obj_.texture_points.emplace_back(n[0], n[1]);
  }

  /// The index that stands at `at`, which is moved behind it; a negative one counts from the last of `size`.
  std::uint32_t read_index(const char*& at, const char* end, std::size_t size, std::string_view word) {
    std::int64_t index = 0;
    const auto [next, error] = std::from_chars(at, end, index);
    if (error != std::errc()) place_.refuse_line(lines_.number(), excerpt(word) + " is not a corner of a face");
    at = next;
    if (index < 0) index += static_cast<std::int64_t>(size) + 1;
    if (index < 1 || index >= ObjText::none)
      place_.refuse_line(lines_.number(), "the index in " + excerpt(word) + " is out of range: " + std::to_string(size) +
                                              " such points stand before it, the first is 1");
    return static_cast<std::uint32_t>(index - 1);
  }

  /// POSITION, POSITION/TEXTURE, POSITION//NORMAL or POSITION/TEXTURE/NORMAL.
  ObjText::Corner read_corner(std::string_view word) {
    ObjText::Corner corner;
    const char* at = word.data();
    const char* const end = at + word.size();
    corner.position = read_index(at, end, obj_.positions.size(), word);
    note_index(corner.position, largest_position_);
    if (at != end && *at++ == '/' && at != end && *at != '/') {
      corner.texture_point = read_index(at, end, obj_.texture_points.size(), word);
      note_index(corner.texture_point, largest_texture_point_);
    }
    return corner;
  }

  void read_face(std::string_view rest) {
    corners_.clear();
    for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest))
      corners_.push_back(read_corner(word));
    if (corners_.size() < 3) {
      if (lines_.is_unended()) refuse_short_line({});
      ++obj_.points_and_lines;
      return;
    }
    ObjText::Part& part = current_part();
    part.corners.insert(part.corners.end(), corners_.begin(), corners_.end());
    part.face_ends.push_back(static_cast<std::uint32_t>(part.corners.size()));
  }

  ObjText::Part& current_part() {
    if (!part_) {
      const auto [found, is_new] = part_of_.try_emplace({object_, material_}, obj_.parts.size());
      if (is_new) obj_.parts.push_back({object_, material_, {}, {}});
      part_ = found->second;
    }
    return obj_.parts[*part_];
  }

  static std::uint32_t index_of(std::string_view name, std::vector<std::string>& names,
                                std::unordered_map<std::string, std::uint32_t>& known) {
    const auto [found, is_new] = known.try_emplace(std::string(name), static_cast<std::uint32_t>(names.size()));
    if (is_new) names.emplace_back(name);
    return found->second;
  }

  void read_other(std::string_view keyword, std::string_view rest) {
    if (keyword == "o" || keyword == "g") {
      object_ = index_of(rest, obj_.object_names, object_index_);
      part_.reset();
    } else if (keyword == "usemtl") {
      material_ = rest.empty() ? ObjText::none : index_of(rest, obj_.material_names, material_index_);
      part_.reset();
    } else if (keyword == "mtllib") {
      obj_.libraries.emplace_back(rest);
    } else if (keyword == "l" || keyword == "p") {
      ++obj_.points_and_lines;
    } else if (!statements_without_effect.contains(keyword)) {
      obj_.unknown_statements.insert(excerpt(keyword));
    }
  }

  /// The largest index so far, counted from 1, and its line. Faces may stand before their vertices.
  struct LargestIndex {
    std::size_t index = 0, line = 0;
  };

  void note_index(std::uint32_t index, LargestIndex& largest) const {
    if (index >= largest.index) largest = {std::size_t{index} + 1, lines_.number()};
  }

  void check_index(const LargestIndex& largest, std::size_t size, const std::string& kind) const {
    if (largest.index > size)
      place_.refuse_line(largest.line, "the index " + std::to_string(largest.index) + " is out of range: there are " +
                                           std::to_string(size) + " " + kind);
  }

  void finish() {
    check_index(largest_position_, obj_.positions.size(), "vertices");
    check_index(largest_texture_point_, obj_.texture_points.size(), "texture points");
    if (coloured_ == obj_.positions.size()) return;
    obj_.colours_are_partial = coloured_ > 0;
    obj_.colours.clear();
  }

  TextLines lines_;
  const ModelPlace& place_;
  ObjText obj_{{}, {}, {}, {}, {""}, {}, {}, 0, {}, false, false};
  std::unordered_map<std::string, std::uint32_t> object_index_{{"", 0}}, material_index_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> part_of_;
  std::uint32_t object_ = 0, material_ = ObjText::none;
  std::optional<std::size_t> part_;  // of the next face, where it is known
  std::size_t coloured_ = 0;
  LargestIndex largest_position_, largest_texture_point_;
  std::vector<ObjText::Corner> corners_;
};

}  // namespace

ObjText parse_obj(std::string_view text, const ModelPlace& place) { return ObjParser(text, place).run(); }

}  // namespace gibench
