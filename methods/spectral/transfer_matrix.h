/// The transfer matrix in memory: sparse, 16 bits a coefficient, and its product with the projected light.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/spectral/rgb4.h"

namespace gibench::spectral {

/// Rows of (value, column) pairs, each row padded to a multiple of eight. Values are whole multiples of their column's step
/// (Wang et al. 2007, section 3.3: quantisation), those that come to zero are left out; or, where there are no steps, floats.
class TransferMatrix {
 public:
  TransferMatrix() = default;
  /// `steps`: one a column, > 0; empty: nothing is rounded, exact zeros alone are left out. `constant`: light of one radiance,
  /// projected. What rounding takes from a row's answer to it is handed on to the next of its columns, so that no more than half
  /// a step is lost.
  TransferMatrix(std::vector<float> steps, std::vector<float> constant)
      : steps_(std::move(steps)), constant_(std::move(constant)) {}

  std::size_t rows() const { return row_begin_.size() - 1; }
  std::size_t columns() const { return constant_.size(); }
  std::uint64_t coefficients() const { return coefficients_; }  ///< kept, padding not counted
  std::size_t bytes() const;

  /// The rows of a block, made by one thread.
  class Block {
   public:
    explicit Block(const TransferMatrix& matrix) : matrix_(&matrix) {}
    void add_row(std::span<const float> dense);

   private:
    friend class TransferMatrix;
    void add(std::uint32_t column, float value);
    void add_rounded(std::span<const float> dense);
    const TransferMatrix* matrix_;
    std::vector<std::uint32_t> row_sizes_;
    std::vector<std::int16_t> quantised_;
    std::vector<float> exact_;
    std::vector<std::uint16_t> column_;
    std::uint64_t coefficients_ = 0;
  };
  /// Blocks in the order of their rows.
  void append(const Block& block);

  /// out[row] = Σ value · light[column]; on chunks of rows.
  void multiply(std::span<const Rgb4> light, std::span<Rgb4> out, Task& task) const;
  /// Adds factor times a row to a dense one.
  void add_row_to(std::size_t row, float factor, std::span<double> dense) const;

 private:
  std::vector<float> steps_, constant_;
  std::vector<std::uint64_t> row_begin_{0};  ///< into the arrays below
  std::vector<std::int16_t> quantised_;
  std::vector<float> exact_;
  std::vector<std::uint16_t> column_;
  std::uint64_t coefficients_ = 0;
};

}  // namespace gibench::spectral
