#include "methods/wavelet/blocks.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace gibench::wavelet {

namespace {

constexpr std::size_t block_chunk = 4096;

/// The pairs of one element with others.
class Refinement {
 public:
  Refinement(const Elements& elements, const Kernel& kernel, const RefinementRule& rule, RayStream& rays, const Task& task)
      : nodes_(elements.nodes()), kernel_(kernel), rule_(rule), rays_(rays), task_(task) {}

  void refine(std::uint32_t receiver, std::uint32_t sender) {
    if (blocks.size() > rule_.most_blocks || task_.cancelled()) return;
    const Exchange exchange = kernel_.between(receiver, sender, rays_);
    ++visits;
    const Node &to = nodes_[receiver], &from = nodes_[sender];
    const bool splits_receiver = !to.is_leaf() && static_cast<double>(exchange.receiver_spread) > rule_.receiver_threshold;
    const bool splits_sender = !from.is_leaf() && static_cast<double>(exchange.sender_spread) > rule_.sender_threshold;
    if (!splits_receiver && !splits_sender) {
      if (!(exchange.total > 0.0F)) return;
      blocks.push_back(
          {receiver, sender, along(to, exchange.receiver, exchange.total), along(from, exchange.sender, exchange.total)});
      return;
    }
    for (std::uint32_t i = 0; i < (splits_receiver ? child_count : 1); ++i)
      for (std::uint32_t j = 0; j < (splits_sender ? child_count : 1); ++j)
        refine(splits_receiver ? to.first_child + i : receiver, splits_sender ? from.first_child + j : sender);
  }

  std::vector<Block> blocks;
  std::uint64_t visits = 0;

 private:
  Four along(const Node& node, const Four& shares, float total) const {
    Four result{};
    if (node.is_leaf()) {
      result[0] = std::sqrt(total / node.area);
      return result;
    }
    for (std::size_t i = 0; i < child_count; ++i) {
      const float area = nodes_[node.first_child + i].area;
      if (area > 0.0F) result[i] = shares[i] / std::sqrt(area * total);
    }
    return result;
  }

  std::span<const Node> nodes_;
  const Kernel& kernel_;
  const RefinementRule& rule_;
  RayStream& rays_;
  const Task& task_;
};

}  // namespace

Blocks::Blocks(const World& world, const Elements& elements, const Kernel& kernel, const RefinementRule& rule, Task& task) {
  const std::span roots = elements.elements();
  std::vector<std::vector<Block>> found(roots.size());
  std::vector<std::uint64_t> visits(roots.size(), 0);
  std::atomic<std::size_t> count{0};
  // The pairs of a fixed number of elements, then a sign of life.
  const std::size_t rounds = std::min<std::size_t>(roots.size(), 8);
  for (std::size_t round = 0; round < rounds && !task.cancelled(); ++round) {
    const std::size_t first = roots.size() * round / rounds, last = roots.size() * (round + 1) / rounds;
    task.parallel_chunks(last - first, 1, [&](const ChunkRange& range) {
      const std::size_t to = first + range.begin;
      if (count.load(std::memory_order_relaxed) > rule.most_blocks) return;
      RayStream rays = task.rays(world);
      Refinement refinement(elements, kernel, rule, rays, task);
      for (std::size_t from = rule.symmetric() ? to + 1 : 0; from < roots.size(); ++from)
        if (from != to) refinement.refine(roots[to].root, roots[from].root);
      visits[to] = refinement.visits;
      count.fetch_add(refinement.blocks.size(), std::memory_order_relaxed);
      found[to] = std::move(refinement.blocks);
    });
    task.progress("direct transport", 0.1 + 0.6 * static_cast<double>(round + 1) / static_cast<double>(rounds));
  }
  for (const std::uint64_t looked_at : visits) task.count("pairs_looked_at", looked_at);
  refused_ = count > rule.most_blocks;
  if (refused_ || task.cancelled()) return;
  blocks_.reserve(count);
  for (std::vector<Block>& part : found) {
    blocks_.insert(blocks_.end(), part.begin(), part.end());
    std::vector<Block>().swap(part);
  }
  index(elements.nodes().size(), rule.symmetric());
}

void Blocks::index(std::size_t nodes, bool symmetric) {
  begin_.assign(nodes + 1, 0);
  for (const Block& block : blocks_) {
    ++begin_[block.receiver + 1];
    if (symmetric) ++begin_[block.sender + 1];
  }
  for (std::size_t n = 0; n < nodes; ++n) begin_[n + 1] += begin_[n];
  references_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    references_[next[blocks_[b].receiver]++] = 2 * b;
    if (symmetric) references_[next[blocks_[b].sender]++] = 2 * b + 1;
  }
}

void Blocks::scale(const Elements& elements, std::span<const float> factor_of_node, Task& task) {
  const auto scale_end = [&](std::uint32_t node, Four& along) {
    const Node& at = elements.nodes()[node];
    for (std::size_t i = 0; i < (at.is_leaf() ? 1 : child_count); ++i)
      along[i] *= factor_of_node[at.is_leaf() ? node : at.first_child + i];
  };
  task.parallel_chunks(blocks_.size(), block_chunk, [&](const ChunkRange& range) {
    for (std::size_t b = range.begin; b < range.end; ++b) {
      scale_end(blocks_[b].receiver, blocks_[b].along_receiver);
      scale_end(blocks_[b].sender, blocks_[b].along_sender);
    }
  });
}

}  // namespace gibench::wavelet
