/// The transfer matrix in memory: sparse blocks of eight rows, 16 bits a coefficient, and its product with the projected light.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/spectral/colour_lanes.h"
#include "methods/spectral/rgb4.h"

namespace gibench::spectral {

/// Rows that share their columns, at most.
constexpr std::size_t block_rows = lane_count;

/// What is left out of the rows of a matrix. As it is made: exact zeros alone, and values are floats.
struct Truncation {
  std::vector<float> importance;  ///< > 0, one per column: how much light it usually carries; empty: nothing else is left out
  float threshold = 0.0F;         ///< a block keeps columns of which the root mean square value times importance is above it
  bool rounding = false;          ///< it keeps those of which a value does not round to zero instead, and changes no other value
  bool eight_bits = true;         ///< for columns without a large value
};

/// Rows of (value, column) pairs, in blocks of up to eight rows that are alike and share their columns: a column number is held
/// once for eight values, and a product is eight rows at a time. With a truncation values are 16-bit whole numbers (Wang et al.
/// 2007, section 3.3), q · row scale / importance, the row's scale such that its largest is 32767; where there is a threshold,
/// those of columns with no value above 63 thresholds are 8-bit numbers of half a threshold.
class TransferMatrix {
 public:
  TransferMatrix() = default;
  /// `constant`: light of one radiance, projected. What truncation takes from a row's answer to it goes to those of its columns
  /// that are kept, of which one always is.
  TransferMatrix(Truncation truncation, std::vector<float> constant)
      : truncation_(std::move(truncation)), constant_(std::move(constant)) {}

  std::size_t rows() const { return first_row_.back(); }
  std::size_t columns() const { return constant_.size(); }
  /// Kept: zeros among them, but not the rows that a short block lacks.
  std::uint64_t coefficients() const { return coefficients_; }
  std::size_t bytes() const;

  /// Blocks of rows, made by one thread.
  class Section {
   public:
    explicit Section(const TransferMatrix& matrix) : matrix_(&matrix) {}
    /// One to eight dense rows, one behind the other.
    void add_block(std::span<const float> rows) { add_block(rows, rows); }
    /// With the columns that the rows `alike` would keep, zeros or not.
    void add_block(std::span<const float> rows, std::span<const float> alike);

   private:
    friend class TransferMatrix;
    void keep_columns(std::span<const float> rows, std::size_t count);
    void keep_what_rounds_to_something(std::span<const float> rows);
    void keep_answer_to_constant(std::span<const float> rows, std::size_t count, std::size_t adjusted,
                                 std::span<float> kept) const;
    std::size_t part_wide_from_narrow(std::span<float> kept);
    void quantise_narrow(std::size_t wide, std::span<float> kept);
    void quantise(std::span<const float> kept);
    std::span<const std::uint16_t> columns_of_block() const { return std::span(column_).subspan(block_begin_.back()); }

    const TransferMatrix* matrix_;
    std::vector<std::uint32_t> first_row_{0}, block_begin_{0}, wide_begin_{0};
    std::vector<std::int16_t> quantised_;
    std::vector<std::int8_t> narrow_;
    std::vector<float> exact_, row_scale_;
    std::vector<std::uint16_t> column_;
  };
  /// Sections in the order of their rows.
  void append(const Section& section);

  /// out[row] = Σ value · light[column]; on chunks of blocks.
  void multiply(std::span<const Rgb4> light, std::span<Rgb4> out, Task& task) const;
  /// Adds factor times a row to a dense one.
  void add_row_to(std::size_t row, float factor, std::span<double> dense) const;

 private:
  bool rounded() const { return !truncation_.importance.empty(); }
  float narrow_step() const {
    return truncation_.eight_bits ? 0.5F * truncation_.threshold : 0.0F;
  }  ///< of values times importance

  Truncation truncation_;
  std::vector<float> constant_;
  std::vector<std::uint32_t> first_row_{0};  ///< of every block, and one more
  std::vector<std::uint64_t> block_begin_{
      0};                                     ///< of every block, and one more: into the columns, and times eight into the values
  std::vector<std::uint64_t> wide_begin_{0};  ///< of every block, and one more: how many columns before it have 16 bits a value
  std::vector<std::uint16_t> column_;         ///< in every block those of 16 bits first
  std::vector<std::int16_t> quantised_;       ///< a column's eight rows next to one another
  std::vector<std::int8_t> narrow_;           ///< the same of columns of 8 bits
  std::vector<float> exact_;                  ///< the same of all, where nothing is rounded
  std::vector<float> row_scale_;              ///< eight a block, where something is
  std::uint64_t coefficients_ = 0;
};

}  // namespace gibench::spectral
