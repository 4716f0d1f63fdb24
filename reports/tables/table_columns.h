/// Columns of a table with what fills them: title, name and cell of a column stand in one place.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reports/tables/table_cells.h"

namespace gibench::report {

/// The columns of a table whose rows are made of `Row`, in their order. `of` takes a row and gives the datum that each kind
/// of column names, or nothing where it was not measured.
template <class Row>
class Columns {
 public:
  /// Gives a Cell.
  template <class Of>
  Columns& cells(Column column, Of of) {
    columns_.push_back({std::move(column), std::move(of)});
    return *this;
  }
  /// Gives a std::string; set to the left.
  template <class Of>
  Columns& text(std::string title, std::string name, Of of) {
    return cells({std::move(title), std::move(name), false}, [of](const Row& row) { return text_cell(of(row)); });
  }
  template <class Of>
  Columns& seconds(std::string title, std::string name, Of of) {
    return number(std::move(title), std::move(name), of, seconds_cell);
  }
  template <class Of>
  Columns& bytes(std::string title, std::string name, Of of) {
    return number(std::move(title), std::move(name), of, bytes_cell);
  }
  /// A number of things that is rounded for people: 7.80 M.
  template <class Of>
  Columns& count(std::string title, std::string name, Of of) {
    return number(std::move(title), std::move(name), of, count_cell);
  }
  /// A whole number with all its digits.
  template <class Of>
  Columns& whole(std::string title, std::string name, Of of) {
    return cells({std::move(title), std::move(name)}, [of](const Row& row) { return whole_cell(std::optional(of(row))); });
  }
  /// A number to three digits.
  template <class Of>
  Columns& rounded(std::string title, std::string name, Of of) {
    return number(std::move(title), std::move(name), of, number_cell);
  }

  /// The table of one row for each of `rows`.
  Table table(std::string name, std::string caption, const std::vector<Row>& rows) const {
    Table table{std::move(name), std::move(caption), {}, {}};
    for (const Filled& column : columns_) table.columns.push_back(column.heading);
    for (const Row& row : rows) {
      table.rows.emplace_back();
      for (const Filled& column : columns_) table.rows.back().push_back(column.cell(row));
    }
    return table;
  }

 private:
  struct Filled {
    Column heading;
    std::function<Cell(const Row&)> cell;
  };

  template <class Of, class ToCell>
  Columns& number(std::string title, std::string name, Of of, ToCell to_cell) {
    return cells({std::move(title), std::move(name)}, [of, to_cell](const Row& row) { return to_cell(of(row)); });
  }

  std::vector<Filled> columns_;
};

}  // namespace gibench::report
