/// The numbers of a PLY file after its header, one record after the other.
#pragma once

#include <cstring>
#include <string_view>
#include <vector>

#include "common/scene_io/ply/ply_header.h"

namespace gibench {

/// The values of one record: the number of each property, or its list.
struct PlyRecord {
  std::vector<double> numbers;             ///< by property; unused for lists
  std::vector<std::vector<double>> lists;  ///< by property; empty for numbers
};

/// Reads the records of a file in their order. Refuses a file that ends before a record does, or a line of a text that has other
/// than the numbers announced.
class PlyRecords {
 public:
  PlyRecords(std::string_view bytes, const PlyHeader& header, const ModelPlace& place);

  /// The next record, the `index`-th of `element`.
  void read(const PlyElement& element, std::uint64_t index, PlyRecord& record);

  /// Bytes after the last record, line ends and blanks at the end left out.
  std::size_t bytes_left() const;

 private:
  void read_line(const PlyElement& element, std::uint64_t index, PlyRecord& record);
  double text_number(std::string_view& rest, const PlyElement& element, std::uint64_t index) const;
  double binary_number(PlyType type, const PlyElement& element, std::uint64_t index);
  std::size_t list_size(double count, std::size_t most, const PlyElement& element, std::uint64_t index) const;
  [[noreturn]] void refuse_end(const PlyElement& element, std::uint64_t index) const;

  std::string_view rest_;
  const PlyHeader& header_;
  const ModelPlace& place_;
  std::size_t line_;
  char line_end_;
};

}  // namespace gibench
