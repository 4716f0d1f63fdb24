#include "methods/spectral/transfer_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/core/error.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t block_chunk = 64;  // blocks
constexpr float most = std::numeric_limits<std::int16_t>::max(), most_narrow = std::numeric_limits<std::int8_t>::max();

/// Eight numbers as floats.
Lanes numbers(const float* from) { return load_numbers(from); }
Lanes numbers(const std::int16_t* from) { return load_numbers(from); }
Lanes numbers(const std::int8_t* from) {
  using ByteLanes = std::int8_t __attribute__((vector_size(lane_count)));
  return __builtin_convertvector(__builtin_convertvector(load_lanes<ByteLanes>(from), LaneMask), Lanes);
}

/// Eight rows' sums. Two chains of additions, so that one need not wait for the other.
template <class Value>
ColourLanes block_sum(const Value* values, std::span<const std::uint16_t> columns, const Rgb4* light) {
  ColourLanes even, odd;
  std::size_t i = 0;
  for (; i + 2 <= columns.size(); i += 2) {
    even.add(numbers(values + i * block_rows), light[columns[i]]);
    odd.add(numbers(values + (i + 1) * block_rows), light[columns[i + 1]]);
  }
  if (i < columns.size()) even.add(numbers(values + i * block_rows), light[columns[i]]);
  even += odd;
  return even;
}

void store_rows(const ColourLanes& colours, std::span<Rgb4> out) {
  if (out.size() == block_rows) return store(colours, out.data());
  std::array<Rgb4, block_rows> all;
  store(colours, all.data());
  std::copy_n(all.begin(), out.size(), out.begin());
}

}  // namespace

void TransferMatrix::Section::keep_columns(std::span<const float> rows, std::size_t count) {
  const std::size_t columns = matrix_->columns();
  const Truncation& truncation = matrix_->truncation_;
  bool constant_kept = false;
  std::size_t best = columns;  // of those that carry constant light
  float best_answer = 0.0F;
  for (std::size_t c = 0; c < columns; ++c) {
    float squares = 0.0F;
    for (std::size_t r = 0; r < count; ++r) squares += rows[r * columns + c] * rows[r * columns + c];
    const float usual = std::sqrt(squares / static_cast<float>(count));
    const bool carries_constant = matrix_->constant_[c] != 0.0F;
    if (const float answer = usual * std::fabs(matrix_->constant_[c]); answer > best_answer) best_answer = answer, best = c;
    if (!(usual > 0.0F) || (matrix_->rounded() && !(usual * truncation.importance[c] > truncation.threshold))) continue;
    column_.push_back(static_cast<std::uint16_t>(c));
    constant_kept |= carries_constant;
  }
  if (matrix_->rounded() && !constant_kept && best < columns) column_.push_back(static_cast<std::uint16_t>(best));
}

void TransferMatrix::Section::keep_what_rounds_to_something(std::span<const float> rows) {
  const std::size_t columns = matrix_->columns();
  const std::vector<float>& importance = matrix_->truncation_.importance;
  std::vector<bool> kept(columns, false);
  for (std::size_t begin = 0; begin < rows.size(); begin += columns) {
    float largest = 0.0F;
    for (std::size_t c = 0; c < columns; ++c) largest = std::max(largest, std::fabs(rows[begin + c]) * importance[c]);
    for (std::size_t c = 0; c < columns; ++c)
      kept[c] = kept[c] || std::fabs(rows[begin + c]) * importance[c] * most > 0.5F * largest;
  }
  for (std::size_t c = 0; c < columns; ++c)
    if (kept[c]) column_.push_back(static_cast<std::uint16_t>(c));
}

void TransferMatrix::Section::add_block(std::span<const float> rows, std::span<const float> alike) {
  const std::size_t columns = matrix_->columns(), count = rows.size() / columns;
  GIBENCH_CHECK(count > 0 && count <= block_rows && rows.size() == count * columns, "a block has one to eight whole rows");
  GIBENCH_CHECK(alike.size() == rows.size(), "rows that choose columns are as many");
  const bool rounding = matrix_->truncation_.rounding;
  if (rounding) keep_what_rounds_to_something(alike);
  else keep_columns(alike, count);
  const std::span<const std::uint16_t> own = columns_of_block();
  std::vector<float> kept(own.size() * block_rows, 0.0F);
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t r = 0; r < count; ++r) kept[i * block_rows + r] = rows[r * columns + own[i]];
  std::size_t wide = own.size();
  if (matrix_->rounded()) {
    if (!rounding) {
      keep_answer_to_constant(rows, count, own.size(), kept);
      wide = part_wide_from_narrow(kept);
      quantise_narrow(wide, kept);
      keep_answer_to_constant(rows, count, wide, kept);
    }
    quantise(std::span(kept).first(wide * block_rows));
  } else {
    exact_.insert(exact_.end(), kept.begin(), kept.end());
  }
  first_row_.push_back(first_row_.back() + static_cast<std::uint32_t>(count));
  block_begin_.push_back(static_cast<std::uint32_t>(column_.size()));
  wide_begin_.push_back(wide_begin_.back() + static_cast<std::uint32_t>(wide));
}

/// Puts the columns whose values 8 bits can hold behind the others; how many these are. The one that carries most of the constant
/// stays among them.
std::size_t TransferMatrix::Section::part_wide_from_narrow(std::span<float> kept) {
  const std::span own = std::span(column_).subspan(block_begin_.back());
  if (!(matrix_->narrow_step() > 0.0F)) return own.size();
  const auto squared = [&](std::size_t i) {
    float sum = 0.0F;
    for (std::size_t r = 0; r < block_rows; ++r) sum += kept[i * block_rows + r] * kept[i * block_rows + r];
    return sum * matrix_->constant_[own[i]] * matrix_->constant_[own[i]];
  };
  std::size_t carrier = 0;
  for (std::size_t i = 1; i < own.size(); ++i)
    if (squared(i) > squared(carrier)) carrier = i;
  const float limit = most_narrow * matrix_->narrow_step();
  std::vector<std::size_t> order;
  const auto is_narrow = [&](std::size_t i) {
    const float importance = matrix_->truncation_.importance[own[i]];
    const auto values = kept.subspan(i * block_rows, block_rows);
    return i != carrier && std::ranges::all_of(values, [&](float value) { return std::fabs(value) * importance <= limit; });
  };
  for (std::size_t i = 0; i < own.size(); ++i) order.push_back(i);
  const auto narrow = std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !is_narrow(i); });
  const std::vector<std::uint16_t> columns(own.begin(), own.end());
  const std::vector<float> values(kept.begin(), kept.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    own[i] = columns[order[i]];
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(order[i] * block_rows), block_rows,
                kept.begin() + static_cast<std::ptrdiff_t>(i * block_rows));
  }
  return static_cast<std::size_t>(narrow - order.begin());
}

/// The columns from `wide` on; `kept` is what they hold then.
void TransferMatrix::Section::quantise_narrow(std::size_t wide, std::span<float> kept) {
  const std::span<const std::uint16_t> own = columns_of_block();
  const float step = matrix_->narrow_step();
  for (std::size_t i = wide * block_rows; i < kept.size(); ++i) {
    const float importance = matrix_->truncation_.importance[own[i / block_rows]];
    const float number = std::clamp(std::nearbyint(kept[i] * importance / step), -most_narrow, most_narrow);
    narrow_.push_back(static_cast<std::int8_t>(number));
    kept[i] = number * step / importance;
  }
}

/// What was dropped of the answer to constant light is spread so that it changes the answers to other lights least: minimising
/// Σ (importance · change)² with Σ constant · change given, each of the first `adjusted` columns changes by
/// constant / importance².
void TransferMatrix::Section::keep_answer_to_constant(std::span<const float> rows, std::size_t count, std::size_t adjusted,
                                                      std::span<float> kept) const {
  const std::span<const std::uint16_t> own = columns_of_block();
  const std::vector<float>&constant = matrix_->constant_, &importance = matrix_->truncation_.importance;
  const auto ratio = [&](std::size_t c) {
    return static_cast<double>(constant[c]) / (static_cast<double>(importance[c]) * static_cast<double>(importance[c]));
  };
  double whole = 0.0;
  for (const std::uint16_t c : own.first(adjusted)) whole += ratio(c) * static_cast<double>(constant[c]);
  if (!(whole > 0.0)) return;
  for (std::size_t r = 0; r < count; ++r) {
    double lost = 0.0;
    for (std::size_t c = 0; c < constant.size(); ++c)
      lost += static_cast<double>(constant[c]) * static_cast<double>(rows[r * constant.size() + c]);
    for (std::size_t i = 0; i < own.size(); ++i)
      lost -= static_cast<double>(constant[own[i]]) * static_cast<double>(kept[i * block_rows + r]);
    for (std::size_t i = 0; i < adjusted; ++i)
      if (constant[own[i]] != 0.0F) kept[i * block_rows + r] += static_cast<float>(lost * ratio(own[i]) / whole);
  }
}

void TransferMatrix::Section::quantise(std::span<const float> kept) {
  const std::span<const std::uint16_t> own = columns_of_block();
  float scale[block_rows] = {};
  for (std::size_t i = 0; i < kept.size(); ++i)
    scale[i % block_rows] =
        std::max(scale[i % block_rows], std::fabs(kept[i]) * matrix_->truncation_.importance[own[i / block_rows]] / most);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const float scaled = kept[i] * matrix_->truncation_.importance[own[i / block_rows]], step = scale[i % block_rows];
    quantised_.push_back(static_cast<std::int16_t>(step > 0.0F ? std::clamp(std::nearbyint(scaled / step), -most, most) : 0.0F));
  }
  row_scale_.insert(row_scale_.end(), std::begin(scale), std::end(scale));
}

void TransferMatrix::append(const Section& section) {
  const std::uint32_t row = first_row_.back();
  const std::uint64_t begin = block_begin_.back(), wide = wide_begin_.back();
  for (std::size_t b = 1; b < section.first_row_.size(); ++b) {
    first_row_.push_back(row + section.first_row_[b]);
    block_begin_.push_back(begin + section.block_begin_[b]);
    coefficients_ += std::uint64_t{section.first_row_[b] - section.first_row_[b - 1]} *
                     (section.block_begin_[b] - section.block_begin_[b - 1]);
    wide_begin_.push_back(wide + section.wide_begin_[b]);
  }
  quantised_.insert(quantised_.end(), section.quantised_.begin(), section.quantised_.end());
  narrow_.insert(narrow_.end(), section.narrow_.begin(), section.narrow_.end());
  exact_.insert(exact_.end(), section.exact_.begin(), section.exact_.end());
  row_scale_.insert(row_scale_.end(), section.row_scale_.begin(), section.row_scale_.end());
  column_.insert(column_.end(), section.column_.begin(), section.column_.end());
}

void TransferMatrix::multiply(std::span<const Rgb4> light, std::span<Rgb4> out, Task& task) const {
  GIBENCH_CHECK(light.size() == columns() && out.size() == rows(), "one light per column, one answer per row");
  std::vector<Rgb4> scaled(light.begin(), light.end());
  for (std::size_t c = 0; c < truncation_.importance.size(); ++c) scaled[c] = Rgb(light[c]) / truncation_.importance[c];
  task.parallel_chunks(first_row_.size() - 1, block_chunk, [&](const ChunkRange& range) {
    for (std::size_t b = range.begin; b < range.end; ++b) {
      const std::uint64_t begin = block_begin_[b], wide = wide_begin_[b];
      const auto columns = std::span(column_).subspan(begin, block_begin_[b + 1] - begin);
      const std::span<Rgb4> answers = out.subspan(first_row_[b], first_row_[b + 1] - first_row_[b]);
      ColourLanes sum;
      if (rounded()) {
        const std::size_t wide_columns = wide_begin_[b + 1] - wide;
        sum = block_sum(narrow_.data() + (begin - wide) * block_rows, columns.subspan(wide_columns), scaled.data());
        sum *= all_lanes(narrow_step());
        ColourLanes of_wide = block_sum(quantised_.data() + wide * block_rows, columns.first(wide_columns), scaled.data());
        of_wide *= load_numbers(row_scale_.data() + b * block_rows);
        sum += of_wide;
      } else {
        sum = block_sum(exact_.data() + begin * block_rows, columns, scaled.data());
      }
      store_rows(sum, answers);
    }
  });
}

void TransferMatrix::add_row_to(std::size_t row, float factor, std::span<double> dense) const {
  const auto after = std::upper_bound(first_row_.begin(), first_row_.end(), row);
  const auto block = static_cast<std::size_t>(after - first_row_.begin()) - 1, lane = row - first_row_[block];
  const std::uint64_t begin = block_begin_[block], wide = wide_begin_[block], narrow_from = begin + wide_begin_[block + 1] - wide;
  const auto value_at = [&](std::uint64_t i) {
    if (!rounded()) return exact_[i * block_rows + lane];
    const float scaled =
        i < narrow_from
            ? static_cast<float>(quantised_[(wide + i - begin) * block_rows + lane]) * row_scale_[block * block_rows + lane]
            : static_cast<float>(narrow_[(i - wide_begin_[block + 1]) * block_rows + lane]) * narrow_step();
    return scaled / truncation_.importance[column_[i]];
  };
  for (std::uint64_t i = begin; i < block_begin_[block + 1]; ++i) dense[column_[i]] += static_cast<double>(factor * value_at(i));
}

std::size_t TransferMatrix::bytes() const {
  return first_row_.size() * sizeof(std::uint32_t) + (block_begin_.size() + wide_begin_.size()) * sizeof(std::uint64_t) +
         narrow_.size() + quantised_.size() * sizeof(std::int16_t) + column_.size() * sizeof(std::uint16_t) +
         (exact_.size() + row_scale_.size() + truncation_.importance.size() + constant_.size()) * sizeof(float);
}

}  // namespace gibench::spectral
