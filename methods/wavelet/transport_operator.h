/// The direct transport operator as links between groups of coefficients, stored by receiver.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/wavelet/elements.h"
#include "methods/wavelet/settings.h"

namespace gibench::wavelet {

/// The links of some receiving groups, one after the other.
struct LinkRows {
  std::vector<std::uint32_t> counts;   ///< links of each group
  std::vector<std::uint32_t> senders;  ///< groups, ascending in each row
  std::vector<float> coefficients;     ///< of each link: functions of the receiver × functions of the sender, row by row
  double dropped = 0.0, kept = 0.0;    ///< sums of squares of coefficients
  std::uint64_t dropped_links = 0;
};

/// Sparse rows of dense blocks of 1 to 16 numbers; light that leaves as radiosity arrives as irradiance. One matrix for all
/// channels: colours are in the reflectances, which multiply the senders' coefficients.
class TransportOperator {
 public:
  TransportOperator() = default;
  /// `parts` in the order of the groups.
  TransportOperator(const Elements& elements, std::vector<LinkRows>&& parts, Precision precision);

  std::size_t links() const { return senders_.size(); }
  std::size_t coefficients() const { return coefficients_.size() + packed_.size(); }
  std::size_t bytes() const;

  /// `out` = this × `in`; both of four slots a group.
  void apply(const Elements& elements, std::span<const Rgb> in, std::span<Rgb> out, Task& task) const;

  /// Calls visit(sender, coefficients) for the links of a receiving group.
  template <class Visit>
  void each_link(const Elements& elements, std::uint32_t receiver, const Visit& visit) const {
    std::size_t at = coefficient_begin_[receiver];
    const std::size_t rows = elements.groups()[receiver].functions();
    std::array<float, child_count * child_count> unpacked;
    for (std::uint32_t link = row_begin_[receiver]; link < row_begin_[receiver + 1]; ++link) {
      const std::size_t count = rows * elements.groups()[senders_[link]].functions();
      if (!packed_.empty()) {
        for (std::size_t i = 0; i < count; ++i) unpacked[i] = step_of_row_[receiver] * static_cast<float>(packed_[at + i]);
        visit(senders_[link], std::span<const float>(unpacked).first(count));
      } else {
        visit(senders_[link], std::span(coefficients_).subspan(at, count));
      }
      at += count;
    }
  }

 private:
  void pack();

  std::vector<std::uint32_t> row_begin_, senders_;
  std::vector<std::size_t> coefficient_begin_;
  std::vector<float> coefficients_;   ///< of 32 bits; or
  std::vector<std::int16_t> packed_;  ///< of 16, …
  std::vector<float> step_of_row_;    ///< … in units of 1/32767 of the largest of each row
};

}  // namespace gibench::wavelet
