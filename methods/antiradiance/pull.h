/// From the leaves up: a node's value is its children's mean by area.
#pragma once

#include <span>
#include <vector>

#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {

/// Calls at_leaf(node, its number) and at_inner(node, left, right, the left child's share of the area) with the numbers of the
/// nodes, children before parents.
template <class AtLeaf, class AtInner>
void from_leaves_up(const Hierarchy& hierarchy, const AtLeaf& at_leaf, const AtInner& at_inner) {
  const auto nodes = hierarchy.nodes();
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (nodes[i].is_leaf()) at_leaf(i, nodes[i].begin);
    else at_inner(i, i + 1, std::size_t{nodes[i].right}, nodes[i + 1].area / nodes[i].area);
}

template <class Value>
Value mean_by_area(const Value& left, const Value& right, float share) {
  return left * share + right * (1.0F - share);
}

/// Values of the leaves in all nodes.
template <class Value>
std::vector<Value> pull(const Hierarchy& hierarchy, std::span<const Value> leaves) {
  std::vector<Value> values(hierarchy.size());
  from_leaves_up(
      hierarchy, [&](std::size_t node, std::size_t leaf) { values[node] = leaves[leaf]; },
      [&](std::size_t node, std::size_t left, std::size_t right, float share) {
        values[node] = mean_by_area(values[left], values[right], share);
      });
  return values;
}

}  // namespace gibench::antiradiance
