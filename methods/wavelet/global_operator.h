/// The global transport operator: all bounces in one sparse matrix, by the Neumann series of the direct one (section 4.4).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/wavelet/elements.h"
#include "methods/wavelet/transport_operator.h"

namespace gibench::wavelet {

struct SeriesRule {
  double threshold = 1e-4;  ///< links of a power without a larger coefficient are left out, and end the series
  int most_powers = 100;
  std::size_t most_bytes = std::size_t{2} << 30U;  ///< of the operator while it is made
};

/// One power of the direct operator, after compression.
struct PowerCount {
  std::uint64_t links = 0, coefficients = 0;  ///< a coefficient has three channels
  double squares = 0.0;                       ///< sum over all coefficients and channels
};

/// T + T² + …, the powers compressed one by one. A row of a power needs the same row of the power before and no other: rows are
/// made one by one, and no power is ever held as a whole. A row ends where nothing of a power is left, or less than rounding of
/// the sum.
class GlobalOperator {
 public:
  GlobalOperator() = default;
  /// `reflectance`: albedo of every element; it becomes part of the operator.
  GlobalOperator(const Elements& elements, const TransportOperator& direct, std::span<const Rgb> reflectance,
                 const SeriesRule& rule, Task& task);

  bool empty() const { return row_begin_.empty(); }
  /// It would have passed the rule's bytes: it is empty.
  bool refused() const { return refused_; }
  std::size_t links() const { return senders_.size(); }
  std::size_t coefficients() const { return coefficients_.size(); }
  std::size_t bytes() const;
  /// From the first power on.
  std::span<const PowerCount> powers() const { return powers_; }

  /// Indirect irradiance from that straight from the lights; four slots a group.
  void apply(const Elements& elements, std::span<const Rgb> in, std::span<Rgb> out, Task& task) const;

 private:
  class RowMaker;
  struct Rows;

  std::vector<std::uint32_t> row_begin_, senders_;
  std::vector<std::size_t> coefficient_begin_;
  std::vector<Rgb> coefficients_;
  std::vector<PowerCount> powers_;
  bool refused_ = false;
};

}  // namespace gibench::wavelet
