#include "methods/antiradiance/link_tracing.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "common/core/random.h"
#include "methods/antiradiance/exchange.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t node_chunk = 32;
constexpr std::uint64_t link_stage = 0x6c696e6bULL, whole_stage = 0x77686f6c65ULL;
constexpr std::size_t most_links = std::numeric_limits<std::uint32_t>::max();  // that rows can number

std::size_t pick(float u, std::size_t count) {
  return std::min(count - 1, static_cast<std::size_t>(u * static_cast<float>(count)));
}

/// One at random, or the next that is not inside geometry: every element of the hierarchy has one.
const CellPoint& exposed_point(std::span<const CellPoint> points, float u) {
  std::size_t at = pick(u, points.size());
  while (!points[at].exposed) at = (at + 1) % points.size();
  return points[at];
}

/// Share of the segments of one link that are free; of those whose ends look away from each other nothing is learnt.
float free_share(const Elements& elements, const Hierarchy& hierarchy, std::uint32_t to, const Sender& sender, int count,
                 RandomStream random, RayStream& rays) {
  int tried = 0, open = 0;
  for (int ray = 0; ray < count; ++ray) {
    const auto points_of = [&](std::uint32_t node) {
      return elements.points(hierarchy.element(hierarchy.leaf_by_area(node, random.next_float())));
    };
    const auto receiving = points_of(to), sending = points_of(sender.node());
    const CellPoint &end = exposed_point(receiving, random.next_float()), &start = exposed_point(sending, random.next_float());
    const Vec3 origin = sender.to_back() ? end.behind : end.origin, target = sender.from_back() ? start.behind : start.origin;
    const Vec3 way = target - origin;
    if ((glm::dot(way, end.normal) < 0.0F) != sender.to_back() || (glm::dot(way, start.normal) > 0.0F) != sender.from_back())
      continue;
    ++tried;
    if (!rays.occluded({origin, 0.0F, way, 1.0F})) ++open;
  }
  return tried > 0 ? static_cast<float>(open) / static_cast<float>(tried) : 1.0F;
}

/// A link that came of another.
struct MadeLink {
  std::uint32_t receiver;
  Sender sender;
  float factor;
};

/// Traces links one by one, and takes them apart.
class Tracer {
 public:
  /// `room`: for so many links that are made.
  Tracer(const Elements& elements, const Hierarchy& hierarchy, const TracingRule& rule, std::size_t room, std::uint64_t seed,
         RayStream& rays)
      : elements_(elements), hierarchy_(hierarchy), rule_(rule), room_(room), seed_(seed), rays_(rays) {}

  /// What is left of the factor; none where the link was taken apart: then `made` has more links.
  float trace(std::uint32_t receiver, const Sender& sender, float factor, std::vector<MadeLink>& made) {
    const float share = share_of(link_stage, receiver, sender);
    const Node &p = hierarchy_.nodes()[receiver], &q = hierarchy_.nodes()[sender.node()];
    const bool partial = share > 0.0F && share < 1.0F;
    if (!(factor > rule_.most_partial) || (p.is_leaf() && q.is_leaf())) return factor * share;
    if (room_ < 2) {
      if (partial) ++counts.left_whole;
      return factor * share;
    }
    // That all rays of a link were free, or none, is why it is kept: other rays have to say how much of it is free.
    if (!partial) return factor * share_of(whole_stage, receiver, sender);
    take_apart(receiver, sender, made);
    return 0.0F;
  }

  TracingCounts counts;

 private:
  float share_of(std::uint64_t stage, std::uint32_t receiver, const Sender& sender) {
    const std::uint64_t key = std::uint64_t{receiver} << 32U | sender.bits;
    return free_share(elements_, hierarchy_, receiver, sender, rule_.rays, RandomStream(seed_, stage, key), rays_);
  }

  /// At its larger end.
  void take_apart(std::uint32_t receiver, const Sender& sender, std::vector<MadeLink>& made) {
    ++counts.taken_apart;
    room_ -= 2;
    const Node &p = hierarchy_.nodes()[receiver], &q = hierarchy_.nodes()[sender.node()];
    const bool splits_receiver = q.is_leaf() || (!p.is_leaf() && p.area > q.area);
    const std::uint32_t parent = splits_receiver ? receiver : sender.node();
    for (const std::uint32_t child : {parent + 1, hierarchy_.nodes()[parent].right})
      if (!trace_child(splits_receiver ? child : receiver, splits_receiver ? sender : Sender{child}, made)) ++room_;
  }

  /// Whether a link was made of it that is whole.
  bool trace_child(std::uint32_t receiver, const Sender& sender, std::vector<MadeLink>& made) {
    const float whole = node_exchange(elements_, hierarchy_, rule_.cells, receiver, sender) / hierarchy_.nodes()[receiver].area;
    if (!(whole > 0.0F)) return false;
    const float factor = trace(receiver, sender, whole, made);
    if (factor > 0.0F) made.push_back({receiver, sender, factor});
    return factor > 0.0F;
  }

  const Elements& elements_;
  const Hierarchy& hierarchy_;
  const TracingRule& rule_;
  std::size_t room_;
  std::uint64_t seed_;
  RayStream& rays_;
};

/// The links of the table that have a factor left, and after them those that were made, row by row.
LinkTable put_together(const LinkTable& links, std::span<const std::vector<MadeLink>> made) {
  LinkTable table;
  const std::size_t rows = links.row_begin.size() - 1;
  const auto each_left = [&](const auto& visit) {
    for (std::size_t row = 0; row < rows; ++row)
      for (std::uint32_t link = links.row_begin[row]; link < links.row_begin[row + 1]; ++link)
        if (links.factors[link] > 0.0F) visit(row, links.senders[link], links.factors[link]);
    for (const std::vector<MadeLink>& chunk : made)
      for (const MadeLink& link : chunk) visit(std::size_t{link.receiver}, link.sender, link.factor);
  };
  table.row_begin.assign(rows + 1, 0);
  each_left([&](std::size_t row, const Sender&, float) { ++table.row_begin[row + 1]; });
  for (std::size_t row = 0; row < rows; ++row) table.row_begin[row + 1] += table.row_begin[row];
  table.senders.resize(table.row_begin.back());
  table.factors.resize(table.row_begin.back());
  std::vector<std::uint32_t> next(table.row_begin.begin(), table.row_begin.end() - 1);
  each_left([&](std::size_t row, const Sender& sender, float factor) {
    table.senders[next[row]] = sender;
    table.factors[next[row]++] = factor;
  });
  return table;
}

}  // namespace

TracingCounts trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, const TracingRule& rule,
                          LinkTable& links, Task& task) {
  std::vector<std::vector<MadeLink>> made(chunk_count(hierarchy.size(), node_chunk));
  std::vector<TracingCounts> counts(made.size());
  const double room_a_link = links.size() > 0 ? static_cast<double>(std::min(rule.most_made, most_links - links.size())) /
                                                    static_cast<double>(links.size())
                                              : 0.0;
  task.parallel_chunks(hierarchy.size(), node_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    const auto room_before = [&](std::size_t node) {
      return static_cast<std::size_t>(room_a_link * static_cast<double>(links.row_begin[node]));
    };
    Tracer tracer(elements, hierarchy, rule, room_before(range.end) - room_before(range.begin), task.seed(), rays);
    for (auto p = static_cast<std::uint32_t>(range.begin); p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link)
        links.factors[link] = tracer.trace(p, links.senders[link], links.factors[link], made[range.chunk]);
    counts[range.chunk] = tracer.counts;
  });
  links = put_together(links, made);
  TracingCounts sum;
  for (const TracingCounts& chunk : counts) sum.taken_apart += chunk.taken_apart, sum.left_whole += chunk.left_whole;
  return sum;
}

}  // namespace gibench::antiradiance
