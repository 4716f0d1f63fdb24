#include "common/scene_io/stl/stl_facets.h"

#include <array>
#include <cstring>

#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

// A binary file: 80 bytes of any text, the count of facets, and for each a normal and three corners in single precision, and
// two bytes that programs use as they like.
constexpr std::size_t header_bytes = 84, facet_bytes = 50, normal_bytes = 12;

std::uint32_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= header_bytes) std::memcpy(&count, bytes.data() + header_bytes - sizeof count, sizeof count);
  return count;
}

bool begins_as_text(std::string_view bytes) {
  while (!bytes.empty() && (trimmed(bytes.substr(0, 1)).empty())) bytes.remove_prefix(1);
  return lower_case(bytes.substr(0, 5)) == "solid";
}

StlFacets parse_binary(std::string_view bytes, const ModelPlace& place) {
  if (bytes.size() < header_bytes)
    place.refuse("is no STL: it neither begins with \"solid\" nor has the 84 bytes before the facets of a binary one",
                 "it may be cut short; copy or export the whole file again");
  const std::size_t count = facet_count(bytes), fitting = (bytes.size() - header_bytes) / facet_bytes;
  if (count > fitting)
    place.refuse_cut_short("it announces " + std::to_string(count) + " facets, and " + std::to_string(fitting) + " follow");
  StlFacets facets;
  if (const std::size_t left = bytes.size() - header_bytes - count * facet_bytes; left > 0)
    facets.warnings.push_back(std::to_string(left) + " bytes after the last facet are left out");
  if (bytes.substr(0, header_bytes).find("COLOR=") != std::string_view::npos)
    facets.warnings.emplace_back("the colours of its facets are left out");
  StlSolid& solid = facets.solids.emplace_back();
  for (std::size_t f = 0; f < count; ++f) {
    std::array<float, 9> numbers;
    std::memcpy(numbers.data(), bytes.data() + header_bytes + f * facet_bytes + normal_bytes, sizeof numbers);
    for (std::size_t i = 0; i < 9; i += 3) solid.corners.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    solid.facet_ends.push_back(static_cast<std::uint32_t>(solid.corners.size()));
  }
  return facets;
}

class StlText {
 public:
  StlText(std::string_view text, const ModelPlace& place) : lines_(text), place_(place) {}

  StlFacets run() {
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      while (!rest.empty()) read_statement(rest);
    }
    if (is_in_facet_) place_.refuse_cut_short("it ends within a facet");
    if (is_in_solid_) facets_.warnings.emplace_back("it ends without \"endsolid\"");
    return std::move(facets_);
  }

 private:
  /// Statements may share a line, but a name goes to its end.
  void read_statement(std::string_view& rest) {
    const std::string_view word = take_word(rest);
    const std::string keyword = lower_case(word);
    if (keyword == "solid") begin_solid(rest);
    else if (keyword == "endsolid") is_in_solid_ = false, rest = {};
    else if (keyword == "facet") begin_facet(rest);
    else if (keyword == "vertex") solid().corners.push_back(numbers(rest));
    else if (keyword == "endfacet") end_facet();
    else if (keyword == "outer") take_word(rest);  // loop
    else if (keyword != "endloop") place_.refuse_line(lines_.number(), excerpt(word) + " is not understood");
  }

  StlSolid& solid() {
    if (facets_.solids.empty() || !is_in_facet_) place_.refuse_line(lines_.number(), "a vertex outside a facet");
    return facets_.solids.back();
  }

  void begin_solid(std::string_view& rest) {
    facets_.solids.emplace_back();
    facets_.solids.back().name = rest;
    is_in_solid_ = true;
    rest = {};
  }

  void begin_facet(std::string_view& rest) {
    if (facets_.solids.empty()) place_.refuse_line(lines_.number(), "a facet outside a solid");
    std::string_view after = rest;
    if (lower_case(take_word(after)) == "normal") {
      rest = after;
      for (int i = 0; i < 3; ++i) take_word(rest);  // it follows from the corners, and is often not a number
    }
    is_in_facet_ = true;
  }

  void end_facet() {
    if (!is_in_facet_) place_.refuse_line(lines_.number(), "\"endfacet\" without a facet");
    StlSolid& now = solid();
    is_in_facet_ = false;
    now.facet_ends.push_back(static_cast<std::uint32_t>(now.corners.size()));
  }

  Vec3d numbers(std::string_view& rest) {
    Vec3d position;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = take_word(rest);
      const auto number = to_number(word);
      if (!number && lines_.is_unended()) place_.refuse_cut_short("its last line is " + excerpt(lines_.line()));
      if (!number)
        place_.refuse_line(lines_.number(),
                           word.empty() ? "a vertex of fewer than three numbers" : excerpt(word) + " is not a number");
      position[axis] = *number;
    }
    return position;
  }

  TextLines lines_;
  const ModelPlace& place_;
  StlFacets facets_;
  bool is_in_solid_ = false, is_in_facet_ = false;
};

}  // namespace

StlFacets parse_stl(std::string_view bytes, const ModelPlace& place) {
  const bool is_binary =
      bytes.size() >= header_bytes && bytes.size() == header_bytes + facet_bytes * std::size_t{facet_count(bytes)};
  if (is_binary) return parse_binary(bytes, place);
  const std::string_view text = without_byte_order_mark(bytes, place);
  return begins_as_text(text) ? StlText(text, place).run() : parse_binary(bytes, place);
}

}  // namespace gibench
