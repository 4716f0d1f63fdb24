#include "common/scene_io/assimp/model_text.h"

#include <assimp/MemoryIOWrapper.h>

#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/assimp/model_name.h"

namespace gibench {

namespace {

// Positions are moved where their distance from the origin is more than this many times the model's extent: there
// single precision would lose bits that the model has.
constexpr double far_in_extents = 4.0;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Calls visit(line) for every line, without its end; returns whether the text ends with a line end.
template <class Visit>
bool for_each_line(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const auto end = text.find('\n');
    visit(text.substr(0, end));
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end + 1);
  }
  return true;
}

std::size_t count_words(std::string_view line) {
  std::size_t words = 0;
  bool inside = false;
  for (const char c : line) {
    const bool in_word = !is_blank(c) && c != '\r';
    if (in_word && !inside) ++words;
    inside = in_word;
  }
  return words;
}

/// Three numbers of a line "KEYWORD x y z …" and where they end; empty for any other line.
struct PositionLine {
  Vec3d position;
  std::size_t indent, end;  // columns of the keyword and of what follows the numbers
};
std::optional<PositionLine> read_position(std::string_view line, std::string_view keyword) {
  PositionLine found{};
  while (found.indent < line.size() && is_blank(line[found.indent])) ++found.indent;
  if (line.substr(found.indent, keyword.size()) != keyword) return std::nullopt;
  const char* at = line.data() + found.indent + keyword.size();
  const char* const end = line.data() + line.size();
  for (int axis = 0; axis < 3; ++axis) {
    if (at == end || !is_blank(*at)) return std::nullopt;
    while (at != end && (is_blank(*at) || *at == '+')) ++at;
    const auto [next, error] = std::from_chars(at, end, found.position[axis]);
    if (error != std::errc()) return std::nullopt;
    at = next;
  }
  found.end = static_cast<std::size_t>(at - line.data());
  return found;
}

/// The centre of all positions where they lie far from the origin, else zero.
Vec3d far_centre(std::string_view text, std::string_view keyword) {
  Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
  for_each_line(text, [&](std::string_view line) {
    if (const auto found = read_position(line, keyword))
      low = glm::min(low, found->position), high = glm::max(high, found->position);
  });
  const Vec3d centre = 0.5 * (low + high);
  const bool is_far = glm::length(centre) > far_in_extents * glm::length(high - low);  // false for NaN and no positions
  return is_far && std::isfinite(glm::length(centre)) ? centre : Vec3d(0.0);
}

void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(" ").append(digits.data(), end);
}

std::string moved_text(std::string_view text, std::string_view keyword, const Vec3d& shift) {
  std::string moved;
  moved.reserve(text.size() + text.size() / 2);
  for_each_line(text, [&](std::string_view line) {
    if (const auto found = read_position(line, keyword)) {
      moved.append(keyword);
      for (int axis = 0; axis < 3; ++axis) append_number(moved, found->position[axis] - shift[axis]);
      line.remove_prefix(found->end);
    }
    moved.append(line).append("\n");
  });
  return moved;
}

[[noreturn]] void throw_cut_short(const std::string& place, const std::string& file, const std::string& how) {
  throw InputError(place, "the model file " + in_quotes(file) + " is cut short: " + how, "copy or export the whole file again");
}

/// An OBJ that ends without a line end, within a position or a face.
void check_obj_end(std::string_view text, const std::string& file, const std::string& place) {
  std::string_view last;
  if (for_each_line(text, [&](std::string_view line) { last = line; })) return;
  std::istringstream words{std::string(last)};
  std::string keyword;
  words >> keyword;
  if ((keyword == "v" || keyword == "f") && count_words(last) < 4)
    throw_cut_short(place, file, "its last line is " + in_quotes(last));
}

/// An ASCII PLY with fewer lines than its header announces: Assimp would fill the rest up.
void check_ply_lines(std::string_view text, const std::string& file, const std::string& place) {
  bool in_header = true, is_ascii = false;
  std::size_t announced = 0, lines = 0;
  for_each_line(text, [&](std::string_view line) {
    if (!in_header) {
      if (count_words(line) > 0) ++lines;
      return;
    }
    std::istringstream words{std::string(line)};
    std::string keyword, kind;
    std::size_t count = 0;
    words >> keyword >> kind;
    if (keyword == "format") is_ascii = kind == "ascii";
    if (keyword == "element" && words >> count) announced += count;
    if (keyword == "end_header") in_header = false;
  });
  if (text.find("end_header") == std::string_view::npos) throw_cut_short(place, file, "its header has no end_header");
  if (in_header) return;  // lines end in some other way, as on old Macintoshes
  if (is_ascii && lines < announced)
    throw_cut_short(place, file,
                    "its header announces " + std::to_string(announced) + " lines and " + std::to_string(lines) + " follow");
}

}  // namespace

ModelFiles::ModelFiles(const std::filesystem::path& file, const std::string& place) : name_(file.string()) {
  const std::string extension = extension_of(file);
  const bool is_obj = extension == ".obj", is_stl = extension == ".stl", is_ply = extension == ".ply";
  if (!is_obj && !is_stl && !is_ply) return;
  const std::string text = read_file(file);
  if (is_obj) check_obj_end(text, name_, place);
  if (is_ply) check_ply_lines(text, name_, place);
  if (is_ply || (is_stl && !text.starts_with("solid"))) return;
  const std::string_view keyword = is_obj ? "v" : "vertex";
  shift_ = far_centre(text, keyword);
  if (shift_ != Vec3d(0.0)) text_ = moved_text(text, keyword, shift_);
}

Assimp::IOStream* ModelFiles::Open(const char* name, const char* mode) {
  if (text_.empty() || name != name_) return DefaultIOSystem::Open(name, mode);
  return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size());
}

}  // namespace gibench
