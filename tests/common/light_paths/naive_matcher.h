/// A matcher of light-path expressions without any automaton: it tries every way to cut the path into parts.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "common/light_paths/expression.h"

namespace gibench::test {

/// Every place at which a match of the node that begins at `from` can end.
inline std::set<std::size_t> match_ends(const PathNode& node, const std::vector<PathEvent>& path, std::size_t from) {
  std::set<std::size_t> ends;
  switch (node.kind) {
    case PathNode::Kind::event:
      if (from < path.size() && node.events.contains(path[from])) ends.insert(from + 1);
      return ends;
    case PathNode::Kind::choice:
      for (const PathNode& child : node.children) ends.merge(match_ends(child, path, from));
      return ends;
    case PathNode::Kind::sequence:
      ends.insert(from);
      for (const PathNode& child : node.children) {
        std::set<std::size_t> further;
        for (const std::size_t end : ends) further.merge(match_ends(child, path, end));
        ends = std::move(further);
      }
      return ends;
    case PathNode::Kind::repeat: break;
  }
  // A path of n events needs no more than n repetitions that take something, and `least` that may take nothing.
  const int most = node.most.value_or(node.least + static_cast<int>(path.size()));
  std::set<std::size_t> reached{from};
  for (int i = 0; i <= most; ++i) {
    if (i >= node.least) ends.insert(reached.begin(), reached.end());
    std::set<std::size_t> further;
    for (const std::size_t end : reached) further.merge(match_ends(node.children.front(), path, end));
    reached = std::move(further);
  }
  return ends;
}

inline bool naive_match(const PathExpression& expression, const std::vector<PathEvent>& path) {
  return match_ends(expression.root, path, 0).contains(path.size());
}

}  // namespace gibench::test
