/// The header of a PLY file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene_io/text/model_place.h"

namespace gibench {

/// The types of numbers.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The ways in which a file holds them.
enum class PlyFormat { ascii, little_endian, big_endian };

std::size_t bytes_of(PlyType type);

/// One number, or a list of them.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< of lists
};

/// `count` records of the same properties.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes that every record has at least: in a binary file its numbers and the counts of its lists; in a text a digit and
  /// a blank for each.
  std::uint64_t least_bytes(PlyFormat format) const;
};

/// Elements in the order of the data, which begin at `data_at`.
struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::string picture;  ///< of a comment `TextureFile`; empty where there is none
  std::size_t data_at = 0;
  std::size_t lines = 0;
};

/// Reads the header of the file's bytes. Refuses what it does not understand, and counts for which the file is too short.
PlyHeader parse_ply_header(std::string_view bytes, const ModelPlace& place);

}  // namespace gibench
