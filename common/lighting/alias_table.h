/// Draws one of many items with given probabilities in constant time (Walker 1977, built as in Vose 1991).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gibench {

class AliasTable {
 public:
  AliasTable() = default;
  /// Weights ≥ 0; all zero makes an empty table.
  explicit AliasTable(std::span<const double> weights);

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  /// The item at `u` in [0, 1).
  std::uint32_t draw(float u) const;
  float probability(std::uint32_t item) const { return entries_[item].probability; }

 private:
  struct Entry {
    float threshold = 1.0F;  ///< keep the item below it, else take the alias
    std::uint32_t alias = 0;
    float probability = 0.0F;
  };
  std::vector<Entry> entries_;
};

}  // namespace gibench
