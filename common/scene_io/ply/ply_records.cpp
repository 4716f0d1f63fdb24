#include "common/scene_io/ply/ply_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

template <class T>
double value_of(std::array<char, 8> bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  return static_cast<double>(value);
}

double value_of(PlyType type, const std::array<char, 8>& bytes) {
  switch (type) {
    case PlyType::int8: return value_of<std::int8_t>(bytes);
    case PlyType::uint8: return value_of<std::uint8_t>(bytes);
    case PlyType::int16: return value_of<std::int16_t>(bytes);
    case PlyType::uint16: return value_of<std::uint16_t>(bytes);
    case PlyType::int32: return value_of<std::int32_t>(bytes);
    case PlyType::uint32: return value_of<std::uint32_t>(bytes);
    case PlyType::float32: return value_of<float>(bytes);
    case PlyType::float64: return value_of<double>(bytes);
  }
  return 0.0;
}

std::string name_of(const PlyElement& element, std::uint64_t index) {
  return excerpt(element.name) + " " + std::to_string(index) + " of " + std::to_string(element.count);
}

}  // namespace

PlyRecords::PlyRecords(std::string_view bytes, const PlyHeader& header, const ModelPlace& place)
    : rest_(bytes.substr(header.data_at)),
      header_(header),
      place_(place),
      line_(header.lines),
      line_end_(bytes[header.data_at - 1]) {}

void PlyRecords::refuse_end(const PlyElement& element, std::uint64_t index) const {
  place_.refuse_cut_short("it ends before " + name_of(element, index));
}

std::size_t PlyRecords::list_size(double count, std::size_t most, const PlyElement& element, std::uint64_t index) const {
  if (count >= 0.0 && count <= static_cast<double>(most) && count == static_cast<double>(static_cast<std::size_t>(count)))
    return static_cast<std::size_t>(count);
  place_.refuse(fmt::format("has a list of {:.0f} numbers in {}, and has no bytes for them", count, name_of(element, index)),
                "it is damaged or cut short; copy or export it again");
}

double PlyRecords::binary_number(PlyType type, const PlyElement& element, std::uint64_t index) {
  const std::size_t size = bytes_of(type);
  if (rest_.size() < size) refuse_end(element, index);
  std::array<char, 8> bytes{};
  std::copy_n(rest_.begin(), size, bytes.begin());
  if (header_.format == PlyFormat::big_endian) std::reverse(bytes.begin(), bytes.begin() + size);
  rest_.remove_prefix(size);
  return value_of(type, bytes);
}

double PlyRecords::text_number(std::string_view& rest, const PlyElement& element, std::uint64_t index) const {
  const std::string_view word = take_word(rest);
  if (const auto number = to_number(word)) return *number;
  if (rest_.empty()) refuse_end(element, index);
  if (word.empty()) place_.refuse_line(line_, "it has fewer numbers than the header announces for " + name_of(element, index));
  place_.refuse_line(line_, excerpt(word) + " is not a number");
}

void PlyRecords::read_line(const PlyElement& element, std::uint64_t index, PlyRecord& record) {
  std::string_view line;
  while (line.empty()) {
    if (rest_.empty()) refuse_end(element, index);
    const auto end = rest_.find(line_end_);
    line = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
  }
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const double number = text_number(line, element, index);
    record.numbers[p] = number;
    if (!element.properties[p].count_type) continue;
    record.lists[p].resize(list_size(number, line.size() / 2 + 1, element, index));
    for (double& value : record.lists[p]) value = text_number(line, element, index);
  }
  if (!line.empty()) place_.refuse_line(line_, "it has more numbers than the header announces for " + name_of(element, index));
}

void PlyRecords::read(const PlyElement& element, std::uint64_t index, PlyRecord& record) {
  record.numbers.resize(element.properties.size());
  record.lists.resize(element.properties.size());
  if (header_.format == PlyFormat::ascii) return read_line(element, index, record);
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    record.numbers[p] = binary_number(property.count_type.value_or(property.type), element, index);
    if (!property.count_type) continue;
    record.lists[p].resize(list_size(record.numbers[p], rest_.size() / bytes_of(property.type), element, index));
    for (double& value : record.lists[p]) value = binary_number(property.type, element, index);
  }
}

std::size_t PlyRecords::bytes_left() const {
  const auto last = rest_.find_last_not_of(" \t\r\n\f\v");
  return header_.format == PlyFormat::ascii ? (last == std::string_view::npos ? 0 : last + 1) : rest_.size();
}

}  // namespace gibench
