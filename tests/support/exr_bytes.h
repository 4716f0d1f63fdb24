/// EXR files made byte by byte, of kinds that no writer at hand makes.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gibench::test {

/// A channel of 32-bit floats; `sampling` 2 keeps every second pixel of every second row.
struct ExrChannel {
  std::string name;
  std::vector<float> samples;
  int sampling = 1;
};

/// One attribute of a header.
struct ExrAttribute {
  std::string name, type, value;
};

/// One part: an uncompressed scanline picture. The channels stand in the order of their names.
struct ExrPart {
  int width = 0, height = 0;
  std::vector<ExrChannel> channels;
  std::vector<ExrAttribute> attributes;  ///< besides those that every picture has
  std::string name;                      ///< of files with several parts
};

inline void add_number(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffU);
}

inline void add_int(std::string& bytes, int value) { add_number(bytes, static_cast<std::uint32_t>(value), 4); }

inline void add_float(std::string& bytes, float value) { add_number(bytes, std::bit_cast<std::uint32_t>(value), 4); }

/// The value of an attribute of numbers, such as chromaticities.
inline std::string exr_floats(const std::vector<float>& numbers) {
  std::string bytes;
  for (const float number : numbers) add_float(bytes, number);
  return bytes;
}

inline void add_text(std::string& bytes, std::string_view text) {
  bytes += text;
  bytes += '\0';
}

inline void add_attribute(std::string& bytes, const ExrAttribute& attribute) {
  add_text(bytes, attribute.name);
  add_text(bytes, attribute.type);
  add_int(bytes, static_cast<int>(attribute.value.size()));
  bytes += attribute.value;
}

inline std::string channel_list(const std::vector<ExrChannel>& channels) {
  std::string list;
  for (const ExrChannel& channel : channels) {
    add_text(list, channel.name);
    add_int(list, 2);  // 32-bit float
    add_int(list, 0);
    add_int(list, channel.sampling);
    add_int(list, channel.sampling);
  }
  return list + '\0';
}

inline std::string ints(const std::vector<int>& numbers) {
  std::string bytes;
  for (const int number : numbers) add_int(bytes, number);
  return bytes;
}

inline void add_header(std::string& bytes, const ExrPart& part, bool one_of_several) {
  const std::string window = ints({0, 0, part.width - 1, part.height - 1});
  add_attribute(bytes, {"channels", "chlist", channel_list(part.channels)});
  add_attribute(bytes, {"compression", "compression", std::string(1, '\0')});
  add_attribute(bytes, {"dataWindow", "box2i", window});
  add_attribute(bytes, {"displayWindow", "box2i", window});
  add_attribute(bytes, {"lineOrder", "lineOrder", std::string(1, '\0')});
  add_attribute(bytes, {"pixelAspectRatio", "float", exr_floats({1.0F})});
  add_attribute(bytes, {"screenWindowCenter", "v2f", exr_floats({0.0F, 0.0F})});
  add_attribute(bytes, {"screenWindowWidth", "float", exr_floats({1.0F})});
  for (const ExrAttribute& attribute : part.attributes) add_attribute(bytes, attribute);
  if (one_of_several) {
    add_attribute(bytes, {"name", "string", part.name});
    add_attribute(bytes, {"type", "string", "scanlineimage"});
    add_attribute(bytes, {"chunkCount", "int", ints({part.height})});
  }
  bytes += '\0';
}

inline std::string row_of(const ExrPart& part, int y) {
  std::string row;
  for (const ExrChannel& channel : part.channels) {
    if (y % channel.sampling != 0) continue;
    const int width = part.width / channel.sampling;
    for (int x = 0; x < width; ++x) add_float(row, channel.samples[static_cast<std::size_t>(y / channel.sampling * width + x)]);
  }
  return row;
}

/// A whole file of one or of several parts.
inline std::string exr_bytes(const std::vector<ExrPart>& parts) {
  const bool several = parts.size() > 1;
  std::string bytes = "\x76\x2f\x31\x01";
  add_int(bytes, several ? 0x1002 : 2);
  std::size_t rows = 0;
  for (const ExrPart& part : parts) {
    add_header(bytes, part, several);
    rows += static_cast<std::size_t>(part.height);
  }
  if (several) bytes += '\0';
  std::string chunks;
  const std::size_t first_chunk = bytes.size() + 8 * rows;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (int y = 0; y < parts[i].height; ++y) {
      const std::string row = row_of(parts[i], y);
      add_number(bytes, first_chunk + chunks.size(), 8);
      if (several) add_int(chunks, static_cast<int>(i));
      add_int(chunks, y);
      add_int(chunks, static_cast<int>(row.size()));
      chunks += row;
    }
  return bytes + chunks;
}

}  // namespace gibench::test
