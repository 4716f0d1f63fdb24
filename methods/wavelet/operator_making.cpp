#include "methods/wavelet/operator_making.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace gibench::wavelet {

namespace {

/// A function of the receivers' side against all functions of the senders' side.
struct Row {
  std::vector<std::uint32_t> groups;  ///< of senders, ascending
  std::vector<Four> values;           ///< by slot
};

using Square = std::array<Four, child_count>;  ///< children of a receiver × children or functions of a sender

/// The rows of one receiving element, from its leaves up to its root.
class ElementRows {
 public:
  ElementRows(const Elements& elements, const Blocks& blocks, double compression, const Task& task)
      : elements_(elements),
        nodes_(elements.nodes()),
        blocks_(blocks),
        compression_(compression),
        task_(task),
        by_group_(elements.groups().size()),
        is_touched_(elements.groups().size(), 0) {}

  LinkRows links_of(const Element& element) {
    std::vector<Row> rows(element.end - element.root);
    std::vector<LinkRows> of_groups;
    for (std::uint32_t node = element.end; node-- > element.root;) {
      if (task_.cancelled()) return {};
      gather_blocks(node);
      const Node& at = nodes_[node];
      for (std::size_t child = 0; child < child_count && !at.is_leaf(); ++child)
        add_row(std::exchange(rows[at.first_child + child - element.root], {}), child);
      rows[node - element.root] = finish(node, of_groups);
    }
    LinkRows result;
    for (std::size_t i = of_groups.size(); i-- > 0;) append(of_groups[i], result);
    return result;
  }

 private:
  Square& touch(std::uint32_t group) {
    if (is_touched_[group] == 0) {
      is_touched_[group] = 1;
      touched_.push_back(group);
      by_group_[group] = {};
    }
    return by_group_[group];
  }

  /// The blocks that a node itself receives by, transformed along the sender.
  void gather_blocks(std::uint32_t node) {
    for (std::size_t b = 0; b < blocks_.count_of(node); ++b) {
      const BlockView block = blocks_.view(node, b);
      const Node& from = nodes_[block.sender];
      // A leaf that is no root adds to its parent's children.
      const bool own_group = from.group != none;
      Square& square = touch(own_group ? from.group : nodes_[from.parent].group);
      const std::size_t place = own_group ? 0 : block.sender - nodes_[from.parent].first_child;
      for (std::size_t i = 0; i < child_count; ++i)
        for (std::size_t j = 0; j < (from.is_leaf() ? 1 : child_count); ++j)
          square[i][from.is_leaf() ? place : j] += block.along_receiver[i] * block.along_sender[j];
    }
    pull_senders();
  }

  /// Children's smooth coefficients become functions; what is smooth goes on to the parent. Children's groups are numbered behind
  /// their parents'.
  void pull_senders() {
    std::priority_queue<std::uint32_t> open(std::less<std::uint32_t>(), touched_);
    while (!open.empty()) {
      const std::uint32_t group = open.top();
      open.pop();
      const Node& at = nodes_[elements_.groups()[group].node];
      if (at.is_leaf()) continue;
      Square& square = by_group_[group];
      for (Four& row : square) row = elements_.step(group).up(row);
      if (at.parent == none) continue;
      const std::uint32_t parent = nodes_[at.parent].group;
      if (is_touched_[parent] == 0) open.push(parent);
      Square& above = touch(parent);
      const std::size_t place = elements_.groups()[group].node - nodes_[at.parent].first_child;
      for (std::size_t i = 0; i < child_count; ++i) {
        above[i][place] += by_group_[group][i][0];
        by_group_[group][i][0] = 0.0F;
      }
    }
  }

  /// What arrives at one child.
  void add_row(const Row& row, std::size_t child) {
    for (std::size_t i = 0; i < row.groups.size(); ++i) {
      Four& values = touch(row.groups[i])[child];
      for (std::size_t j = 0; j < child_count; ++j) values[j] += row.values[i][j];
    }
  }

  /// Links of the node's functions; the row of its smooth function.
  Row finish(std::uint32_t node, std::vector<LinkRows>& of_groups) {
    std::sort(touched_.begin(), touched_.end());
    const Node& at = nodes_[node];
    Row smooth;
    LinkRows links;
    for (const std::uint32_t group : touched_) {
      Square& square = by_group_[group];
      if (!at.is_leaf()) square = receivers_up(elements_.step(at.group), square);
      if (at.parent != none) {
        smooth.groups.push_back(group);
        smooth.values.push_back(square[0]);
      }
      if (at.group != none) add_link(elements_.groups()[at.group], group, square, links);
      is_touched_[group] = 0;
    }
    touched_.clear();
    if (at.group != none) {
      links.counts.push_back(static_cast<std::uint32_t>(links.senders.size()));
      of_groups.push_back(std::move(links));
    }
    return smooth;
  }

  static Square receivers_up(const HaarStep& step, const Square& children) {
    Square result{};
    for (std::size_t k = 0; k < child_count; ++k)
      for (std::size_t i = 0; i < child_count; ++i)
        for (std::size_t j = 0; j < child_count; ++j) result[k][j] += step.row(k)[i] * children[i][j];
    return result;
  }

  void add_link(const Group& receiver, std::uint32_t sender, const Square& square, LinkRows& links) const {
    const Group& from = elements_.groups()[sender];
    float largest = 0.0F;
    double squares = 0.0;
    for (std::size_t k = receiver.first; k < receiver.end; ++k)
      for (std::size_t j = from.first; j < from.end; ++j) {
        largest = std::max(largest, std::fabs(square[k][j]));
        squares += static_cast<double>(square[k][j]) * static_cast<double>(square[k][j]);
      }
    const bool smooth = receiver.first == 0 && from.first == 0;
    if (!(largest > 0.0F)) return;
    if (!smooth && static_cast<double>(largest) < compression_) {
      links.dropped += squares;
      ++links.dropped_links;
      return;
    }
    links.kept += squares;
    links.senders.push_back(sender);
    for (std::size_t k = receiver.first; k < receiver.end; ++k)
      for (std::size_t j = from.first; j < from.end; ++j) links.coefficients.push_back(square[k][j]);
  }

  static void append(const LinkRows& from, LinkRows& to) {
    to.counts.insert(to.counts.end(), from.counts.begin(), from.counts.end());
    to.senders.insert(to.senders.end(), from.senders.begin(), from.senders.end());
    to.coefficients.insert(to.coefficients.end(), from.coefficients.begin(), from.coefficients.end());
    to.dropped += from.dropped;
    to.kept += from.kept;
    to.dropped_links += from.dropped_links;
  }

  const Elements& elements_;
  std::span<const Node> nodes_;
  const Blocks& blocks_;
  double compression_;
  const Task& task_;
  std::vector<Square> by_group_;
  std::vector<std::uint8_t> is_touched_;
  std::vector<std::uint32_t> touched_;
};

}  // namespace

OperatorMaking make_operator(const Elements& elements, const Blocks& blocks, double compression, Precision precision,
                             Task& task) {
  const std::span roots = elements.elements();
  std::vector<LinkRows> parts(roots.size());
  task.parallel_chunks(roots.size(), 1, [&](const ChunkRange& range) {
    parts[range.begin] = ElementRows(elements, blocks, compression, task).links_of(roots[range.begin]);
  });
  OperatorMaking made;
  if (task.cancelled()) return made;
  double dropped = 0.0, all = 0.0;
  for (const LinkRows& part : parts) {
    made.dropped_links += part.dropped_links;
    dropped += part.dropped;
    all += part.dropped + part.kept;
  }
  made.dropped_share = all > 0.0 ? std::sqrt(dropped / all) : 0.0;
  made.transport = TransportOperator(elements, std::move(parts), precision);
  return made;
}

}  // namespace gibench::wavelet
