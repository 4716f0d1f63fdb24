#include "methods/antiradiance/refinement.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <mutex>
#include <utility>
#include <vector>

#include "common/core/lanes.h"
#include "methods/antiradiance/oracle.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t wanted_receivers = 512;  // to be worked on side by side

std::size_t size_of(unsigned set) { return static_cast<std::size_t>(std::popcount(set)); }

/// Numbers of nodes, to which those of up to eight lanes are added at a time.
class Queue {
 public:
  Queue() = default;
  explicit Queue(std::span<const std::uint32_t> numbers) { assign(numbers); }

  std::size_t size() const { return size_; }
  std::span<const std::uint32_t> numbers() const { return {numbers_.data(), size_}; }
  /// What comes out past the end is of no meaning.
  IndexLanes eight(std::size_t from) const { return load_lanes<IndexLanes>(numbers_.data() + from); }

  void clear() { size_ = 0; }
  void assign(std::span<const std::uint32_t> numbers) {
    clear();
    make_room(numbers.size());
    std::copy(numbers.begin(), numbers.end(), numbers_.begin());
    size_ = numbers.size();
  }
  void push(const IndexLanes& numbers, std::size_t count) {
    make_room(lane_count);
    store_lanes(numbers_.data() + size_, numbers);
    size_ += count;
  }
  void push_pairs(const IndexLanes& first, const IndexLanes& second, std::size_t count) {
    make_room(2 * lane_count);
    store_lanes(numbers_.data() + size_, __builtin_shufflevector(first, second, 0, 8, 1, 9, 2, 10, 3, 11));
    store_lanes(numbers_.data() + size_ + lane_count, __builtin_shufflevector(first, second, 4, 12, 5, 13, 6, 14, 7, 15));
    size_ += 2 * count;
  }

 private:
  /// For so many more, and eight behind them.
  void make_room(std::size_t more) {
    if (size_ + more + lane_count > numbers_.size()) numbers_.resize(std::max(2 * numbers_.size(), size_ + more + lane_count));
  }

  std::vector<std::uint32_t> numbers_;
  std::size_t size_ = 0;
};

/// Links as they are made.
struct alignas(64) Block {
  static constexpr std::size_t most = 4092;
  std::array<std::uint32_t, most> senders;
  std::array<float, most> factors;
  std::size_t count;
};

/// Hands out blocks to all threads, and keeps their memory.
class BlockPool {
 public:
  Block* take() {
    const std::lock_guard lock(mutex_);
    if (slabs_.empty() || used_ == slabs_.back().size()) slabs_.emplace_back(huge_page / sizeof(Block)), used_ = 0;
    Block* const block = &slabs_.back()[used_++];
    block->count = 0;
    return block;
  }

 private:
  std::mutex mutex_;
  std::vector<LargeArray<Block>> slabs_;
  std::size_t used_ = 0;
};

/// Links in the order in which they are made; what is there is not moved when more come.
class LinkStore {
 public:
  void push(const IndexLanes& senders, const Lanes& factors, std::size_t count, BlockPool& pool) {
    if (blocks_.empty() || blocks_.back()->count + lane_count > Block::most) blocks_.push_back(pool.take());
    Block& block = *blocks_.back();
    store_lanes(block.senders.data() + block.count, senders);
    store_lanes(block.factors.data() + block.count, factors);
    block.count += count;
    size_ += count;
  }
  std::size_t size() const { return size_; }
  std::span<Block* const> blocks() const { return blocks_; }

 private:
  std::vector<Block*> blocks_;
  std::size_t size_ = 0;
};

/// The rows of one receiver and, in preorder, of everything below it.
struct Rows {
  std::uint32_t first = 0;
  std::vector<std::uint32_t> counts;
  LinkStore links;
  std::uint64_t pairs = 0;
};

class Refiner {
 public:
  Refiner(std::span<const Node> nodes, const Oracle& oracle, BlockPool& pool) : nodes_(nodes), oracle_(oracle), pool_(pool) {}

  /// Works off the queue of one receiver: appends its links, and to `passed_on` what its children are to look at.
  void work(std::uint32_t receiver, Queue& queue, Queue& passed_on, Rows& rows) const {
    const Node p = nodes_[receiver];
    const std::size_t before = rows.links.size();
    for (std::size_t from = 0; from < queue.size();) {
      const std::size_t count = std::min(lane_count, queue.size() - from);
      const LaneMask valid = first_lanes(count);
      const IndexLanes senders = queue.eight(from) & std::bit_cast<IndexLanes>(valid);
      from += count;
      const Verdicts found = oracle_.judge(p, senders, valid);
      rows.links.push(packed_lanes(senders | found.sides, found.link), packed_lanes(found.factors, found.link),
                      size_of(found.link), pool_);
      queue.push_pairs(packed_lanes(senders + 1U, found.split_sender), packed_lanes(found.right, found.split_sender),
                       size_of(found.split_sender));
      passed_on.push(packed_lanes(senders, found.split_receiver), size_of(found.split_receiver));
    }
    rows.pairs += queue.size();
    rows.counts.push_back(static_cast<std::uint32_t>(rows.links.size() - before));
  }

  /// The receiver and everything below it.
  void work_down(std::uint32_t receiver, std::span<const std::uint32_t> senders, Rows& rows, std::size_t depth = 0) {
    if (queues_.size() <= depth) queues_.resize(depth + 1), passed_on_.resize(depth + 1);
    const Node& node = nodes_[receiver];
    if (senders.empty()) {
      rows.counts.insert(rows.counts.end(), 2 * (node.end - node.begin) - 1, 0U);
      return;
    }
    queues_[depth].assign(senders);
    passed_on_[depth].clear();
    work(receiver, queues_[depth], passed_on_[depth], rows);
    if (node.is_leaf()) return;
    // The queues of this depth may move when deeper ones are added; what they hold does not.
    const std::span<const std::uint32_t> down = passed_on_[depth].numbers();
    work_down(receiver + 1, down, rows, depth + 1);
    work_down(node.right, down, rows, depth + 1);
  }

 private:
  std::span<const Node> nodes_;
  const Oracle& oracle_;
  BlockPool& pool_;
  std::vector<Queue> queues_, passed_on_;
};

struct Receiver {
  std::uint32_t node;
  Queue senders;
};

/// Puts the rows together in the order of the nodes.
LinkTable assemble(const std::vector<Rows>& all, std::size_t nodes, Task& task) {
  LinkTable table;
  table.row_begin.assign(nodes + 1, 0);
  for (const Rows& rows : all) std::copy(rows.counts.begin(), rows.counts.end(), table.row_begin.begin() + 1 + rows.first);
  for (std::size_t i = 1; i <= nodes; ++i) table.row_begin[i] += table.row_begin[i - 1];
  table.senders.resize(table.row_begin.back());
  table.factors.resize(table.row_begin.back());
  task.parallel_chunks(all.size(), 16, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      std::size_t at = table.row_begin[all[i].first];
      for (const Block* block : all[i].links.blocks()) {
        std::memcpy(static_cast<void*>(table.senders.data() + at), block->senders.data(), block->count * sizeof(Sender));
        std::memcpy(table.factors.data() + at, block->factors.data(), block->count * sizeof(float));
        at += block->count;
      }
    }
  });
  return table;
}

}  // namespace

LinkTable make_links(const Hierarchy& hierarchy, const RefinementRule& rule, Task& task, RefinementCounts& counts) {
  double area = 0.0;
  for (const std::uint32_t root : hierarchy.roots()) area += static_cast<double>(hierarchy.nodes()[root].area);
  const Oracle oracle(hierarchy.nodes(), rule,
                      static_cast<float>(area / static_cast<double>(std::max<std::size_t>(1, hierarchy.leaf_count()))));

  BlockPool pool;
  std::vector<Rows> all;
  std::vector<Receiver> receivers;
  for (std::size_t root = 0; root < hierarchy.roots().size(); ++root)
    receivers.push_back({hierarchy.roots()[root], Queue(hierarchy.roots_beside(root))});
  std::atomic<std::size_t> made{0};

  // Level by level until there are enough receivers, then each with everything below it.
  bool more = true;
  while (more && receivers.size() < wanted_receivers && !task.cancelled()) {
    std::vector<Rows> rows(receivers.size());
    std::vector<Queue> passed_on(receivers.size());
    task.parallel_chunks(receivers.size(), 4, [&](const ChunkRange& range) {
      const Refiner refiner(hierarchy.nodes(), oracle, pool);
      for (std::size_t i = range.begin; i < range.end; ++i) {
        rows[i].first = receivers[i].node;
        refiner.work(receivers[i].node, receivers[i].senders, passed_on[i], rows[i]);
        made.fetch_add(rows[i].links.size(), std::memory_order_relaxed);
      }
    });
    std::vector<Receiver> next;
    more = false;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const Node& node = hierarchy.nodes()[receivers[i].node];
      if (node.is_leaf()) continue;
      next.push_back({receivers[i].node + 1, passed_on[i]});
      next.push_back({node.right, std::move(passed_on[i])});
      more = true;
    }
    for (Rows& one : rows) all.push_back(std::move(one));
    receivers.swap(next);
  }
  const std::size_t first = all.size();
  all.resize(first + receivers.size());
  task.parallel_chunks(receivers.size(), 1, [&](const ChunkRange& range) {
    Refiner refiner(hierarchy.nodes(), oracle, pool);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      if (made.load(std::memory_order_relaxed) > rule.most_links) return;
      Rows& rows = all[first + i];
      rows.first = receivers[i].node;
      refiner.work_down(receivers[i].node, receivers[i].senders.numbers(), rows);
      made.fetch_add(rows.links.size(), std::memory_order_relaxed);
    }
  });
  for (const Rows& rows : all) counts.pairs += rows.pairs;
  counts.too_many = made.load() > rule.most_links;
  if (counts.too_many || task.cancelled()) {
    LinkTable none;
    none.row_begin.assign(hierarchy.size() + 1, 0);
    return none;
  }
  return assemble(all, hierarchy.size(), task);
}

}  // namespace gibench::antiradiance
