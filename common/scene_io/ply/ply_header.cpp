#include "common/scene_io/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> type_names{{{"char", PlyType::int8},
                                               {"int8", PlyType::int8},
                                               {"uchar", PlyType::uint8},
                                               {"uint8", PlyType::uint8},
                                               {"short", PlyType::int16},
                                               {"int16", PlyType::int16},
                                               {"ushort", PlyType::uint16},
                                               {"uint16", PlyType::uint16},
                                               {"int", PlyType::int32},
                                               {"int32", PlyType::int32},
                                               {"uint", PlyType::uint32},
                                               {"uint32", PlyType::uint32},
                                               {"float", PlyType::float32},
                                               {"float32", PlyType::float32},
                                               {"double", PlyType::float64},
                                               {"float64", PlyType::float64}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const ModelPlace& place) : bytes_(bytes), place_(place) {}

  PlyHeader run() {
    if (trimmed(take_line()) != "ply") place_.refuse("is no PLY: its first line is not \"ply\"", "give a PLY file");
    while (true) {
      std::string_view rest = trimmed(take_line());
      const std::string_view keyword = take_word(rest);
      if (keyword == "end_header") break;
      if (keyword == "format") read_format(rest);
      else if (keyword == "element") read_element(rest);
      else if (keyword == "property") read_property(rest);
      else if (keyword == "comment") read_comment(rest);
      else if (keyword != "obj_info" && !keyword.empty()) refuse_line();
    }
    if (!has_format_) place_.refuse("has no line \"format\" in its header", "export it again");
    header_.data_at = at_;
    check_counts();
    return std::move(header_);
  }

 private:
  /// A line of the header. It ends as the first one does, with \n, \r\n or \r, so that a first byte of the data that looks
  /// like the end of a line is none.
  std::string_view take_line() {
    if (at_ >= bytes_.size()) refuse_without_end();
    if (line_end_.empty()) {
      const auto end = bytes_.find_first_of("\r\n");
      if (end != std::string_view::npos) line_end_ = bytes_.substr(end, bytes_.substr(end).starts_with("\r\n") ? 2 : 1);
    }
    const auto end = line_end_.empty() ? std::string_view::npos : bytes_.find(line_end_, at_);
    if (end == std::string_view::npos) refuse_without_end();
    line_ = bytes_.substr(at_, end - at_);
    at_ = end + line_end_.size();
    ++header_.lines;
    return line_;
  }

  [[noreturn]] void refuse_without_end() const {
    place_.refuse("is cut short or damaged: its header has no end_header", "copy or export the whole file again");
  }

  [[noreturn]] void refuse_line() const {
    if (bytes_.find("end_header", at_) == std::string_view::npos) refuse_without_end();
    place_.refuse_line(header_.lines, excerpt(line_) + " is not understood");
  }

  void read_format(std::string_view rest) {
    const std::string_view format = take_word(rest);
    if (format == "ascii") header_.format = PlyFormat::ascii;
    else if (format == "binary_little_endian") header_.format = PlyFormat::little_endian;
    else if (format == "binary_big_endian") header_.format = PlyFormat::big_endian;
    else refuse_line();
    has_format_ = true;
  }

  void read_element(std::string_view rest) {
    PlyElement element;
    element.name = take_word(rest);
    const std::string_view count = take_word(rest);
    const auto [at, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc() || at != count.data() + count.size()) refuse_line();
    header_.elements.push_back(std::move(element));
  }

  PlyType type_of(std::string_view name) const {
    const auto found =
        std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& known) { return known.name == name; });
    if (found == type_names.end()) refuse_line();
    return found->type;
  }

  void read_property(std::string_view rest) {
    if (header_.elements.empty()) refuse_line();
    PlyProperty property;
    std::string_view type = take_word(rest);
    if (type == "list") {
      property.count_type = type_of(take_word(rest));
      if (*property.count_type == PlyType::float32 || *property.count_type == PlyType::float64) refuse_line();
      type = take_word(rest);
    }
    property.type = type_of(type);
    property.name = take_word(rest);
    if (property.name.empty()) refuse_line();
    header_.elements.back().properties.push_back(std::move(property));
  }

  void read_comment(std::string_view rest) {
    if (take_word(rest) == "TextureFile") header_.picture = rest;
  }

  void check_counts() {
    std::uint64_t left = bytes_.size() - at_ + 1;  // the last blank of a text may be missing
    for (const PlyElement& element : header_.elements) {
      const std::uint64_t least = element.least_bytes(header_.format);
      if (least > 0 && element.count > left / least) refuse_count(element);
      left -= least * element.count;
    }
  }

  [[noreturn]] void refuse_count(const PlyElement& element) const {
    place_.refuse_cut_short("its header announces " + std::to_string(element.count) + " records of " + excerpt(element.name) +
                            ", and " + std::to_string(bytes_.size() - at_) + " bytes follow");
  }

  std::string_view bytes_, line_end_, line_;
  const ModelPlace& place_;
  PlyHeader header_;
  std::size_t at_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32: return 4;
    case PlyType::float64: return 8;
  }
  return 0;
}

std::uint64_t PlyElement::least_bytes(PlyFormat format) const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += format == PlyFormat::ascii ? 2 : bytes_of(property.count_type.value_or(property.type));
  return bytes;
}

PlyHeader parse_ply_header(std::string_view bytes, const ModelPlace& place) { return HeaderParser(bytes, place).run(); }

}  // namespace gibench
