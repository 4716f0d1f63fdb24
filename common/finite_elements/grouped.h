/// Items by the group that each is in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gibench {

/// Numbers of items by group, without gaps: the items of group g are items[begin[g]] … items[begin[g + 1] − 1], ascending.
struct Grouped {
  std::vector<std::uint32_t> begin, items;

  Grouped(std::span<const std::uint32_t> group_of_item, std::size_t groups) : begin(groups + 1, 0), items(group_of_item.size()) {
    for (const std::uint32_t group : group_of_item) ++begin[group + 1];
    for (std::size_t g = 0; g < groups; ++g) begin[g + 1] += begin[g];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < group_of_item.size(); ++i) items[next[group_of_item[i]]++] = i;
  }
  std::size_t groups() const { return begin.size() - 1; }
  std::span<const std::uint32_t> of(std::size_t group) const {
    return std::span(items).subspan(begin[group], begin[group + 1] - begin[group]);
  }
};

}  // namespace gibench
