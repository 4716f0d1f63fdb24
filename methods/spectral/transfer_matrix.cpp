#include "methods/spectral/transfer_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/core/error.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t group = 8;  // entries that are taken together
constexpr std::size_t row_chunk = 1024;

using Lanes = float __attribute__((vector_size(32), aligned(4), may_alias));
using LanesOfShort = std::int16_t __attribute__((vector_size(16), aligned(2), may_alias));
using Colour = float __attribute__((vector_size(16), may_alias));

Lanes load(const std::int16_t* from) { return __builtin_convertvector(*reinterpret_cast<const LanesOfShort*>(from), Lanes); }
Lanes load(const float* from) { return *reinterpret_cast<const Lanes*>(from); }
Colour all(float value) { return Colour{value, value, value, value}; }

/// One row's sum. Two chains of additions, so that one need not wait for the other.
template <class Value>
Colour row_sum(const Value* value, const std::uint16_t* column, std::size_t count, const Colour* light) {
  Colour even = all(0.0F), odd = all(0.0F), third = all(0.0F), fourth = all(0.0F);
  for (std::size_t i = 0; i < count; i += group) {
    alignas(32) float v[group];
    *reinterpret_cast<Lanes*>(v) = load(value + i);
    even += all(v[0]) * light[column[i]];
    odd += all(v[1]) * light[column[i + 1]];
    third += all(v[2]) * light[column[i + 2]];
    fourth += all(v[3]) * light[column[i + 3]];
    even += all(v[4]) * light[column[i + 4]];
    odd += all(v[5]) * light[column[i + 5]];
    third += all(v[6]) * light[column[i + 6]];
    fourth += all(v[7]) * light[column[i + 7]];
  }
  return (even + odd) + (third + fourth);
}

}  // namespace

void TransferMatrix::Block::add(std::uint32_t column, float value) {
  column_.push_back(static_cast<std::uint16_t>(column));
  if (matrix_->steps_.empty()) exact_.push_back(value);
  else quantised_.push_back(static_cast<std::int16_t>(value));
}

void TransferMatrix::Block::add_row(std::span<const float> dense) {
  GIBENCH_CHECK(dense.size() == matrix_->columns(), "a row has a value for every column");
  const std::size_t before = column_.size();
  if (matrix_->steps_.empty()) {
    for (std::uint32_t c = 0; c < dense.size(); ++c)
      if (dense[c] != 0.0F) add(c, dense[c]);
  } else {
    add_rounded(dense);
  }
  coefficients_ += column_.size() - before;
  while ((column_.size() - before) % group != 0) add(0, 0.0F);
  row_sizes_.push_back(static_cast<std::uint32_t>(column_.size() - before));
}

void TransferMatrix::Block::add_rounded(std::span<const float> dense) {
  constexpr float most = std::numeric_limits<std::int16_t>::max();
  float lost = 0.0F;  // of the answer to constant light
  for (std::uint32_t c = 0; c < dense.size(); ++c) {
    const float step = matrix_->steps_[c], constant = matrix_->constant_[c];
    const float wanted = constant != 0.0F ? dense[c] + lost / constant : dense[c];
    const float levels = std::clamp(std::nearbyint(wanted / step), -most, most);
    if (constant != 0.0F) lost = (wanted - levels * step) * constant;
    if (levels != 0.0F) add(c, levels);
  }
}

void TransferMatrix::append(const Block& block) {
  for (const std::uint32_t size : block.row_sizes_) row_begin_.push_back(row_begin_.back() + size);
  quantised_.insert(quantised_.end(), block.quantised_.begin(), block.quantised_.end());
  exact_.insert(exact_.end(), block.exact_.begin(), block.exact_.end());
  column_.insert(column_.end(), block.column_.begin(), block.column_.end());
  coefficients_ += block.coefficients_;
}

void TransferMatrix::multiply(std::span<const Rgb4> light, std::span<Rgb4> out, Task& task) const {
  GIBENCH_CHECK(light.size() == columns() && out.size() == rows(), "one light a column, one answer a row");
  std::vector<Rgb4> in_steps(light.begin(), light.end());
  for (std::size_t c = 0; c < steps_.size(); ++c) in_steps[c] = Rgb(light[c]) * steps_[c];
  const auto* const colours = reinterpret_cast<const Colour*>(in_steps.data());
  task.parallel_chunks(rows(), row_chunk, [&](const ChunkRange& range) {
    for (std::size_t row = range.begin; row < range.end; ++row) {
      const std::uint64_t begin = row_begin_[row], count = row_begin_[row + 1] - begin;
      *reinterpret_cast<Colour*>(&out[row]) = steps_.empty()
                                                  ? row_sum(exact_.data() + begin, column_.data() + begin, count, colours)
                                                  : row_sum(quantised_.data() + begin, column_.data() + begin, count, colours);
    }
  });
}

void TransferMatrix::add_row_to(std::size_t row, float factor, std::span<double> dense) const {
  for (std::uint64_t i = row_begin_[row]; i < row_begin_[row + 1]; ++i) {
    const float value = steps_.empty() ? exact_[i] : static_cast<float>(quantised_[i]) * steps_[column_[i]];
    dense[column_[i]] += static_cast<double>(factor * value);
  }
}

std::size_t TransferMatrix::bytes() const {
  return row_begin_.size() * sizeof(std::uint64_t) + quantised_.size() * sizeof(std::int16_t) + exact_.size() * sizeof(float) +
         column_.size() * sizeof(std::uint16_t) + (steps_.size() + constant_.size()) * sizeof(float);
}

}  // namespace gibench::spectral
