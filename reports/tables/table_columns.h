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
  /// A column of CSV alone, where people read the datum in the text of another.
  template <class Of, class ToCell>
  Columns& in_csv(std::string name, Of of, ToCell to_cell) {
    return cells({"", std::move(name), true, false}, [of, to_cell](const Row& row) { return to_cell(of(row)); });
  }
  /// An error with its interval; in CSV the ends of the interval and whether it is resolved have columns of their own.
  /// `of` gives a `const MeasuredError*`.
  template <class Of>
  Columns& error(std::string title, const std::string& name, const Metric& metric, Of of) {
    cells({std::move(title), name}, [of, metric](const Row& row) { return error_cell(metric, of(row)); });
    return error_ends(name, of);
  }
  /// The columns of CSV alone that go with the error `name`.
  template <class Of>
  Columns& error_ends(const std::string& name, Of of) {
    in_csv(name + "_ci95_low", of, [](const MeasuredError* error) { return number_cell(error ? error->low : std::nullopt); });
    in_csv(name + "_ci95_high", of, [](const MeasuredError* error) { return number_cell(error ? error->high : std::nullopt); });
    return in_csv(name + "_resolved", of, [](const MeasuredError* error) {
      return text_cell(!error ? "" : error->resolved ? "yes" : "no");
    });
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
