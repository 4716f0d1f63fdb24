/// A table, and the three ways to write it down.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gibench::report {

struct Cell {
  std::string text;  ///< as people read it: "2.31 %"; the dash where nothing was measured
  std::string raw;   ///< as programs read it: "0.0231"; empty where nothing was measured
};

struct Column {
  std::string title;      ///< heading as people read it
  std::string name;       ///< heading in CSV: snake_case, with the unit
  bool is_number = true;  ///< set to the right
  bool is_shown = true;   ///< to people; one that is not stands in CSV alone, where a cell's text says it already
};

struct Table {
  std::string name;     ///< file name without its ending
  std::string caption;  ///< one or two sentences
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// RFC 4180: a field with a comma, quote or line break is quoted. Has every column.
std::string to_csv(const Table& table);
/// A pipe table under its caption.
std::string to_markdown(const Table& table);
/// A booktabs tabular in a table environment.
std::string to_latex(const Table& table);

/// The table without the columns that are not shown.
Table shown(Table table);

/// Text that is safe inside each format, line breaks made spaces.
std::string escape_html(std::string_view text);
std::string escape_markdown(std::string_view text);
std::string escape_latex(std::string_view text);

}  // namespace gibench::report
