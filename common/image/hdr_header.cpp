#include "common/image/hdr_header.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace gibench {

namespace {

/// Up to the next line end, which is taken too.
std::string take_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  std::string line(rest.substr(0, end));
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return line;
}

std::optional<Chromaticities> chromaticities_in(const std::string& text) {
  std::istringstream numbers(text);
  Chromaticities chromaticities{};
  for (float& number : chromaticities)
    if (!(numbers >> number)) return std::nullopt;
  return chromaticities;
}

void take_fact(HdrHeader& header, const std::string& line) {
  const auto value_of = [&](const std::string& name) { return line.substr(name.size()); };
  if (line.starts_with("PRIMARIES=")) header.primaries = chromaticities_in(value_of("PRIMARIES="));
  if (!line.starts_with("EXPOSURE=")) return;
  double factor = 0.0;
  constexpr double most = 1e20;  // no film is: a float of a pixel has to hold what remains
  if (std::istringstream(value_of("EXPOSURE=")) >> factor && factor > 1.0 / most && factor < most) header.exposure *= factor;
}

}  // namespace

HdrHeader read_hdr_header(std::string_view bytes) {
  HdrHeader header;
  for (std::string line = take_line(bytes); !line.empty(); line = take_line(bytes)) take_fact(header, line);
  // "-Y 512 +X 1024", rows first, or columns first
  std::istringstream size(take_line(bytes));
  std::string first, second;
  double rows = 0.0, columns = 0.0;
  if (size >> first >> rows >> second >> columns) {
    const bool rows_first = first.ends_with('Y');
    header.height = rows_first ? rows : columns;
    header.width = rows_first ? columns : rows;
  }
  return header;
}

}  // namespace gibench
