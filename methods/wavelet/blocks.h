/// The blocks that the refinement leaves: pairs of nodes between which the kernel is smooth, or which cannot be refined.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/wavelet/kernel.h"

namespace gibench::wavelet {

/// The kernel between two nodes as a product: entry (i, j) between smooth functions of their children is
/// along_receiver[i] · along_sender[j]. A leaf stands for itself, with entry 0.
struct Block {
  std::uint32_t receiver = 0, sender = 0;  ///< nodes
  Four along_receiver{}, along_sender{};
};

/// A block as one receiver sees it.
struct BlockView {
  std::uint32_t sender;
  const Four& along_receiver;
  const Four& along_sender;
};

struct RefinementRule {
  double receiver_threshold = 0.0, sender_threshold = 0.0;
  std::size_t most_blocks = 0;
  bool symmetric() const { return receiver_threshold == sender_threshold; }
};

/// All blocks of a scene, by receiver. With equal thresholds each pair is looked at once and serves both ways.
class Blocks {
 public:
  Blocks() = default;
  /// Refines every pair of elements from their roots down (section 4.3.2 of the text): the receiver where its spread is above its
  /// threshold, the sender likewise, or both.
  Blocks(const World& world, const Elements& elements, const Kernel& kernel, const RefinementRule& rule, Task& task);

  /// There were more than the rule allows: none are kept.
  bool refused() const { return refused_; }
  std::size_t size() const { return blocks_.size(); }
  /// Blocks that a node receives by.
  std::size_t count_of(std::uint32_t receiver) const { return begin_[receiver + 1] - begin_[receiver]; }
  BlockView view(std::uint32_t receiver, std::size_t number) const {
    const std::uint32_t reference = references_[begin_[receiver] + number];
    const Block& block = blocks_[reference / 2];
    if (reference % 2 == 0) return {block.sender, block.along_receiver, block.along_sender};
    return {block.receiver, block.along_sender, block.along_receiver};
  }

  /// Multiplies both ends of each block by a factor of each node.
  void scale(const Elements& elements, std::span<const float> factor_of_node, Task& task);

 private:
  void index(std::size_t nodes, bool symmetric);

  std::vector<Block> blocks_;
  std::vector<std::uint32_t> begin_, references_;  ///< of every node: twice the block's number, and one where it is its sender
  bool refused_ = false;
};

}  // namespace gibench::wavelet
