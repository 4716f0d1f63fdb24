#include "methods/spectral/transfer_matrix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/core/random.h"

namespace gibench::test {
namespace {

using namespace spectral;

/// Dense rows, mostly small values and a few large, and light of any kind.
struct DenseMatrix {
  std::size_t columns;
  std::vector<float> values;
  std::vector<Rgb4> light;

  DenseMatrix(std::size_t rows, std::size_t wide) : columns(wide) {
    RandomStream random(1, 2, 3);
    for (std::size_t i = 0; i < rows * columns; ++i) {
      const float size = random.next_float() < 0.8F ? 0.01F : 1.0F;
      values.push_back(size * (2.0F * random.next_float() - 1.0F));
    }
    for (std::size_t c = 0; c < columns; ++c)
      light.emplace_back(Rgb(random.next_float(), random.next_float() - 0.5F, 3.0F * random.next_float()));
  }
  std::size_t rows() const { return values.size() / columns; }
  std::span<const float> block(std::size_t begin, std::size_t size) const {
    return std::span(values).subspan(begin * columns, size * columns);
  }
  float at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Blocks of eight rows, the last of those that are left, in two sections.
TransferMatrix made_of(const DenseMatrix& dense, const Truncation& truncation, const std::vector<float>& constant) {
  TransferMatrix matrix(truncation, constant);
  TransferMatrix::Section first(matrix), second(matrix);
  for (std::size_t begin = 0; begin < dense.rows(); begin += block_rows)
    (begin < dense.rows() / 2 ? first : second).add_block(dense.block(begin, std::min(block_rows, dense.rows() - begin)));
  matrix.append(first);
  matrix.append(second);
  return matrix;
}

std::vector<double> row_of(const TransferMatrix& matrix, std::size_t row, float factor = 1.0F) {
  std::vector<double> dense(matrix.columns(), 0.0);
  matrix.add_row_to(row, factor, dense);
  return dense;
}

std::vector<Rgb4> product(const TransferMatrix& matrix, const std::vector<Rgb4>& light) {
  std::vector<Rgb4> answer(matrix.rows());
  Task task;
  matrix.multiply(light, answer, task);
  return answer;
}

constexpr std::size_t row_counts[] = {1, 7, 8, 9, 16, 1029};  // whole blocks and others

TEST(TransferMatrix, WithoutTruncationItHoldsItsRowsAndItsProductIsTheDenseOne) {
  for (const std::size_t rows : row_counts) {
    const DenseMatrix dense(rows, 37);
    const TransferMatrix matrix = made_of(dense, {}, std::vector<float>(37, 0.0F));
    ASSERT_EQ(matrix.rows(), rows);
    EXPECT_EQ(matrix.coefficients(), rows * 37);
    const std::vector<Rgb4> answer = product(matrix, dense.light);
    for (std::size_t r = 0; r < rows; ++r) {
      RgbDouble expected;
      const std::vector<double> row = row_of(matrix, r, 2.0F);
      for (std::size_t c = 0; c < 37; ++c) {
        EXPECT_EQ(row[c], 2.0 * static_cast<double>(dense.at(r, c)));
        expected += RgbDouble(Rgb(dense.light[c])) * static_cast<double>(dense.at(r, c));
      }
      for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(Rgb(answer[r])[channel], expected[channel], 1e-4);
    }
  }
}

TEST(TransferMatrix, TruncatedProductIsThatOfTheRowsItHolds) {
  for (const std::size_t rows : row_counts) {
    const DenseMatrix dense(rows, 37);
    const TransferMatrix matrix = made_of(dense, {std::vector<float>(37, 1.0F), 0.3F, false}, std::vector<float>(37, 0.0F));
    const std::vector<Rgb4> answer = product(matrix, dense.light);
    for (std::size_t r = 0; r < rows; ++r) {
      RgbDouble expected;
      const std::vector<double> row = row_of(matrix, r);
      for (std::size_t c = 0; c < 37; ++c) expected += RgbDouble(Rgb(dense.light[c])) * row[c];
      for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(Rgb(answer[r])[channel], expected[channel], 1e-4);
    }
  }
}

TEST(TransferMatrix, KeepsTheColumnsThatCountAndThoseTo8Or16Bits) {
  constexpr std::size_t rows = 19, columns = 50;
  const DenseMatrix dense(rows, columns);
  std::vector<float> importance;
  for (std::size_t c = 0; c < columns; ++c) importance.push_back(0.1F * static_cast<float>(1 + c));
  constexpr float threshold = 0.02F;
  const TransferMatrix matrix = made_of(dense, {importance, threshold, false}, std::vector<float>(columns, 0.0F));
  std::uint64_t expected_coefficients = 0, narrow_columns = 0, wide_columns = 0;
  for (std::size_t begin = 0; begin < rows; begin += block_rows) {
    const std::size_t size = std::min(block_rows, rows - begin);
    for (std::size_t c = 0; c < columns; ++c) {
      double squares = 0.0;
      for (std::size_t r = begin; r < begin + size; ++r) squares += std::pow(static_cast<double>(dense.at(r, c)), 2.0);
      const bool kept = std::sqrt(squares / static_cast<double>(size)) * static_cast<double>(importance[c]) > threshold;
      expected_coefficients += kept ? size : 0;
      float largest_of_column = 0.0F;
      for (std::size_t r = begin; r < begin + size; ++r)
        largest_of_column = std::max(largest_of_column, std::fabs(dense.at(r, c)) * importance[c]);
      const bool narrow = largest_of_column <= 63.5F * threshold;
      if (kept) ++(narrow ? narrow_columns : wide_columns);
      for (std::size_t r = begin; r < begin + size; ++r) {
        float largest = 0.0F;  // of the row's values in light, by which its step is set
        for (std::size_t other = 0; other < columns; ++other)
          largest = std::max(largest, std::fabs(dense.at(r, other)) * importance[other]);
        const double half_a_step = 0.51 * static_cast<double>((narrow ? threshold / 2.0F : largest / 32767.0F) / importance[c]);
        EXPECT_NEAR(row_of(matrix, r)[c], kept ? static_cast<double>(dense.at(r, c)) : 0.0, half_a_step);
      }
    }
  }
  EXPECT_EQ(matrix.coefficients(), expected_coefficients);
  EXPECT_GT(matrix.coefficients(), 0U);
  EXPECT_LT(matrix.coefficients(), rows * columns);
  EXPECT_GT(narrow_columns, 0U);
  EXPECT_GT(wide_columns, 0U);
}

TEST(TransferMatrix, TruncationKeepsARowsAnswerToConstantLight) {
  const DenseMatrix dense(100, 40);
  std::vector<float> constant(40, 0.0F), importance(40, 1.0F);
  for (std::size_t c = 0; c < 40; c += 4) constant[c] = 0.5F + static_cast<float>(c % 7), importance[c] = 2.0F * constant[c];
  std::vector<Rgb4> light;
  for (const float c : constant) light.emplace_back(Rgb(c));
  // Up to where nothing passes, and of the columns that carry constant light one is kept all the same.
  for (const float threshold : {0.1F, 1.0F, 5.0F, 1e9F}) {
    const TransferMatrix matrix = made_of(dense, {importance, threshold, false}, constant);
    const std::vector<Rgb4> answer = product(matrix, light);
    for (std::size_t r = 0; r < dense.rows(); ++r) {
      double expected = 0.0;
      for (std::size_t c = 0; c < 40; ++c) expected += static_cast<double>(constant[c]) * static_cast<double>(dense.at(r, c));
      EXPECT_NEAR(answer[r].r, expected, 1e-3);
    }
  }
}

TEST(TransferMatrix, RoundingDropsWhatRoundsToZeroAndNothingElse) {
  const float step = 1.0F / 32767.0F;
  // Two rows, whose largest values are 1 and 10: the second column rounds to zero in both, the third in one.
  const std::vector<float> rows{1.0F, 0.4F * step, 0.6F * step, -0.5F, 10.0F, -4.0F * step, 0.4F * step, 3.0F};
  const Truncation rounding{std::vector<float>(4, 1.0F), 0.0F, true};
  TransferMatrix matrix(rounding, {1.0F, 1.0F, 1.0F, 1.0F});
  TransferMatrix::Section section(matrix);
  section.add_block(rows);
  matrix.append(section);
  EXPECT_EQ(matrix.coefficients(), 2U * 3U);
  for (std::size_t r = 0; r < 2; ++r) {
    const std::vector<double> row = row_of(matrix, r);
    EXPECT_EQ(row[1], 0.0);
    const double half_a_step = 0.501 * static_cast<double>(step) * (r == 0 ? 1.0 : 10.0);
    for (const std::size_t c : {0U, 2U, 3U}) EXPECT_NEAR(row[c], static_cast<double>(rows[4 * r + c]), half_a_step);
  }
}

TEST(TransferMatrix, NoValueIsTooLargeOrTooSmallForARowsScale) {
  const std::vector<float> sizes{1e30F, 1e9F, 1.0F, 1e-20F, 0.0F, 1e-37F};
  std::vector<float> rows;
  for (const float size : sizes) rows.insert(rows.end(), {size, -size, 0.5F * size});
  TransferMatrix matrix({{1.0F, 3.0F, 0.1F}, 0.0F, false}, {0.0F, 0.0F, 0.0F});
  TransferMatrix::Section section(matrix);
  section.add_block(rows);
  matrix.append(section);
  for (std::size_t r = 0; r < sizes.size(); ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto expected = static_cast<double>(rows[3 * r + c]);
      const double step = 3.0 * static_cast<double>(sizes[r]) / 32767.0 / (c == 0 ? 1.0 : c == 1 ? 3.0 : 0.1);
      EXPECT_NEAR(row_of(matrix, r)[c], expected, 0.51 * step + 1e-36);
    }
}

TEST(TransferMatrix, RowsOfNothingAnswerNothing) {
  TransferMatrix matrix({{1.0F, 1.0F}, 0.0F, false}, {1.0F, 0.0F});
  TransferMatrix::Section section(matrix);
  section.add_block(std::vector<float>(6, 0.0F));
  matrix.append(section);
  EXPECT_EQ(matrix.rows(), 3U);
  EXPECT_EQ(matrix.coefficients(), 0U);
  for (const Rgb4& value : product(matrix, {Rgb(1.0F), Rgb(2.0F)})) EXPECT_EQ(value.r, 0.0F);
}

}  // namespace
}  // namespace gibench::test
