#include "methods/antiradiance/refinement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

namespace gibench::antiradiance {

namespace {

constexpr std::size_t wanted_receivers = 512;  // to be worked on side by side
constexpr float coplanar = 1e-5F;              // of the pair's extent: below this height over a plane nothing is seen
constexpr float doubtful_share = 0.25F;        // of the tolerance, for pairs that lie across each other's plane or are bent
constexpr float varying_share = 0.1F;          // likewise for the variation of the sender's light
constexpr float uneven_share = 0.005F;         // of the tolerance, times distance over reach: for a receiver's unevenness
constexpr float bent_sine = 0.35F;             // of a normal cone, about 20 degrees

enum class Verdict : std::uint8_t { drop, link, split_sender, split_receiver };

struct Judgement {
  Verdict verdict;
  float factor;
  std::uint32_t sides;
};

/// The oracle.
class Oracle {
 public:
  Oracle(std::span<const Node> nodes, const RefinementRule& rule, float mean_area)
      : nodes_(nodes),
        rule_(rule),
        per_power_(rule.mean_radiosity * mean_area > 0.0F ? 1.0F / (rule.mean_radiosity * mean_area) : 0.0F) {}

  Judgement judge(const Node& p, std::uint32_t sender) const {
    const Node& q = nodes_[sender];
    const Vec3 d = q.centre - p.centre;
    const float squared = glm::dot(d, d), r = std::sqrt(squared);
    float u = glm::dot(p.normal, d), v = -glm::dot(q.normal, d);
    const float m = glm::dot(p.normal, q.normal), across = std::sqrt(std::max(0.0F, 1.0F - m * m));
    const float extent = r + p.reach + q.reach;
    // How far the heights over the other's plane may stray from those of the centres.
    const float stray_u = q.thickness * std::fabs(m) + q.reach * across + p.thickness + extent * p.cone_sine;
    const float stray_v = p.thickness * std::fabs(m) + p.reach * across + q.thickness + extent * q.cone_sine;
    if (!may_see(p, u, v, stray_u, stray_v, coplanar * extent)) return {Verdict::drop, 0.0F, 0};
    const std::uint32_t sides = (v < 0.0F ? Sender::back_sends : 0U) | (u < 0.0F ? Sender::back_receives : 0U);
    const float exchange = coaxial_exchange(squared, p.area, q.area);
    u = std::fabs(u), v = std::fabs(v);
    if (!(p.is_leaf() && q.is_leaf())) {
      const float to_unit = 1.0F / std::max(r, 1e-30F);
      const float cosines = std::min(1.0F, (u + stray_u) * to_unit) * std::min(1.0F, (v + stray_v) * to_unit);
      const bool doubtful = u < stray_u || v < stray_v || p.cone_sine > bent_sine || q.cone_sine > bent_sine;
      const float limit = rule_.tolerance * (doubtful ? doubtful_share : 1.0F);
      const float weight = importance(exchange * cosines, p, sender);
      // The sender's light is its mean: where it varies as the form factor does, the error is of the second order.
      const bool too_much = weight > limit || weight * q.reach * to_unit > limit * varying_share;
      // A link's light is the same all over the receiver: its error there is of the first order in the receiver's size.
      const bool too_wide = weight * p.reach * to_unit > limit * uneven_share;
      if (too_much && !q.is_leaf() && (p.is_leaf() || q.area >= p.area)) return {Verdict::split_sender, 0.0F, 0};
      if ((too_much || too_wide) && !p.is_leaf()) return {Verdict::split_receiver, 0.0F, 0};
    }
    if (rule_.facing == Facing::fronts && sides != 0) return {Verdict::drop, 0.0F, 0};
    if (!p.black_back && (sides & Sender::back_receives) != 0) return {Verdict::drop, 0.0F, 0};
    const float per_r = r > 0.0F ? 1.0F / r : 0.0F, s = pi * squared + p.area + q.area;
    const float facing = sides == Sender::back_sends || sides == Sender::back_receives ? -m : m;
    const float factor = exchange * orientation_factor(u * per_r, v * per_r, facing, p.area / s, q.area / s) / p.area;
    return {factor > 0.0F ? Verdict::link : Verdict::drop, factor, sides};
  }

 private:
  bool may_see(const Node& p, float u, float v, float stray_u, float stray_v, float flat) const {
    if (rule_.facing == Facing::fronts) return u + stray_u > flat && v + stray_v > flat;
    if (!p.black_back && u + stray_u <= flat) return false;
    return std::fabs(u) + stray_u > flat && std::fabs(v) + stray_v > flat;
  }

  float importance(float exchange, const Node& p, std::uint32_t sender) const {
    if (rule_.radiosity.empty()) return exchange / p.area;
    return exchange * rule_.radiosity[sender] * per_power_;
  }

  std::span<const Node> nodes_;
  const RefinementRule& rule_;
  float per_power_;
};

/// The rows of one receiver and, in preorder, of everything below it.
struct Rows {
  std::uint32_t first = 0;
  std::vector<std::uint32_t> counts;
  std::vector<Sender> senders;
  std::vector<float> factors;
  std::uint64_t pairs = 0;
};

class Refiner {
 public:
  Refiner(std::span<const Node> nodes, const Oracle& oracle) : nodes_(nodes), oracle_(oracle) {}

  /// Works off the queue of one receiver: appends its links, and to `passed_on` what its children are to look at.
  void work(std::uint32_t receiver, std::vector<std::uint32_t>& queue, std::vector<std::uint32_t>& passed_on, Rows& rows) const {
    const Node p = nodes_[receiver];
    const std::size_t before = rows.senders.size();
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint32_t sender = queue[i];
      const Judgement found = oracle_.judge(p, sender);
      if (found.verdict == Verdict::link) {
        rows.senders.push_back({sender | found.sides});
        rows.factors.push_back(found.factor);
      } else if (found.verdict == Verdict::split_sender) {
        queue.push_back(sender + 1);
        queue.push_back(nodes_[sender].right);
      } else if (found.verdict == Verdict::split_receiver) {
        passed_on.push_back(sender);
      }
    }
    rows.pairs += queue.size();
    rows.counts.push_back(static_cast<std::uint32_t>(rows.senders.size() - before));
  }

  /// The receiver and everything below it.
  void work_down(std::uint32_t receiver, std::span<const std::uint32_t> senders, Rows& rows, std::size_t depth = 0) {
    if (queues_.size() <= depth) queues_.resize(depth + 1), passed_on_.resize(depth + 1);
    const Node& node = nodes_[receiver];
    if (senders.empty()) {
      rows.counts.insert(rows.counts.end(), 2 * (node.end - node.begin) - 1, 0U);
      return;
    }
    queues_[depth].assign(senders.begin(), senders.end());
    passed_on_[depth].clear();
    work(receiver, queues_[depth], passed_on_[depth], rows);
    if (node.is_leaf()) return;
    // The vectors of this depth may move when deeper ones are added; what they hold does not.
    const std::span<const std::uint32_t> down = passed_on_[depth];
    work_down(receiver + 1, down, rows, depth + 1);
    work_down(node.right, down, rows, depth + 1);
  }

 private:
  std::span<const Node> nodes_;
  const Oracle& oracle_;
  std::vector<std::vector<std::uint32_t>> queues_, passed_on_;
};

struct Receiver {
  std::uint32_t node;
  std::vector<std::uint32_t> senders;
};

/// Puts the rows together in the order of the nodes.
LinkTable assemble(std::vector<Rows>& all, std::size_t nodes, Task& task) {
  LinkTable table;
  table.row_begin.assign(nodes + 1, 0);
  for (const Rows& rows : all) std::copy(rows.counts.begin(), rows.counts.end(), table.row_begin.begin() + 1 + rows.first);
  for (std::size_t i = 1; i <= nodes; ++i) table.row_begin[i] += table.row_begin[i - 1];
  table.senders.resize(table.row_begin.back());
  table.factors.resize(table.row_begin.back());
  task.parallel_chunks(all.size(), 16, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      Rows& rows = all[i];
      const auto begin = static_cast<std::ptrdiff_t>(table.row_begin[rows.first]);
      std::copy(rows.senders.begin(), rows.senders.end(), table.senders.begin() + begin);
      std::copy(rows.factors.begin(), rows.factors.end(), table.factors.begin() + begin);
      rows = {};
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

  std::vector<Rows> all;
  std::vector<Receiver> receivers;
  for (std::size_t root = 0; root < hierarchy.roots().size(); ++root)
    receivers.push_back({hierarchy.roots()[root], hierarchy.roots_beside(root)});
  std::atomic<std::size_t> made{0};

  // Level by level until there are enough receivers, then each with everything below it.
  bool more = true;
  while (more && receivers.size() < wanted_receivers && !task.cancelled()) {
    std::vector<Rows> rows(receivers.size());
    std::vector<std::vector<std::uint32_t>> passed_on(receivers.size());
    task.parallel_chunks(receivers.size(), 4, [&](const ChunkRange& range) {
      const Refiner refiner(hierarchy.nodes(), oracle);
      for (std::size_t i = range.begin; i < range.end; ++i) {
        rows[i].first = receivers[i].node;
        refiner.work(receivers[i].node, receivers[i].senders, passed_on[i], rows[i]);
        made.fetch_add(rows[i].senders.size(), std::memory_order_relaxed);
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
    Refiner refiner(hierarchy.nodes(), oracle);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      if (made.load(std::memory_order_relaxed) > rule.most_links) return;
      Rows& rows = all[first + i];
      rows.first = receivers[i].node;
      refiner.work_down(receivers[i].node, receivers[i].senders, rows);
      made.fetch_add(rows.senders.size(), std::memory_order_relaxed);
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
