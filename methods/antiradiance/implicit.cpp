#include "methods/antiradiance/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "methods/antiradiance/bin_transport.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 64;

struct Nearest {
  float squared = std::numeric_limits<float>::infinity();
  std::uint32_t sender = 0;
  bool found() const { return squared < std::numeric_limits<float>::infinity(); }
  void offer(float squared_distance, std::uint32_t node) {
    if (squared_distance < squared) squared = squared_distance, sender = node;
  }
};

/// What is known of a bin.
struct Bin {
  Nearest across;        ///< its middle: then nothing of the bin is open
  Nearest pointing;      ///< of the links whose direction lies in it
  float factors = 0.0F;  ///< of all those links
};

/// The nodes from the root down to a leaf.
std::vector<std::uint32_t> path_to(const Hierarchy& hierarchy, std::uint32_t root, std::uint32_t leaf_number) {
  std::vector<std::uint32_t> path{root};
  const auto nodes = hierarchy.nodes();
  while (!nodes[path.back()].is_leaf())
    path.push_back(leaf_number < nodes[nodes[path.back()].right].begin ? path.back() + 1 : nodes[path.back()].right);
  return path;
}

struct Row {
  std::vector<std::uint32_t> senders;
  std::vector<float> factors;
};

/// A bin that the front of an element looks into.
struct Look {
  std::size_t bin;
  Vec3 direction;  ///< unit, away from the element
};

/// The sender stands in every bin whose middle it lies across: it is taken as a square, whose disc of the same area would leave
/// gaps to its neighbours' discs.
void lay_across(const Node& sender, const Vec3& to_sender, std::uint32_t index, std::span<const Look> looks,
                std::span<Bin> bins) {
  const float radius_squared = 0.5F * sender.area, height = glm::dot(sender.normal, to_sender);
  for (const Look& look : looks) {
    const float slope = glm::dot(sender.normal, look.direction);
    const float along = slope < 0.0F ? height / slope : -1.0F;
    const Vec3 off = look.direction * along - to_sender;
    if (!(along > 0.0F) || glm::dot(off, off) > radius_squared) continue;
    bins[look.bin].across.offer(along * along, index);
  }
}

Row nearest_of(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& directions, BinWinner winner,
               const std::vector<std::uint32_t>& path) {
  const Node& leaf = hierarchy.nodes()[path.back()];
  std::vector<float> projected(directions.count());
  projected_bins(directions, leaf.normal, projected);
  std::vector<Look> looks;
  for (std::size_t b = 0; b < directions.count(); ++b)
    if (projected[b] < 0.0F) looks.push_back({b, -directions.direction(b)});
  std::vector<Bin> bins(directions.count());
  for (const std::uint32_t node : path)
    for (std::uint32_t link = links.row_begin[node]; link < links.row_begin[node + 1]; ++link) {
      const std::uint32_t sender = links.senders[link].node();
      const Vec3 to_sender = hierarchy.nodes()[sender].centre - leaf.centre;
      const float squared = glm::dot(to_sender, to_sender);
      if (!(squared > 0.0F)) continue;
      Bin& own = bins[directions.bin_of(to_sender / -std::sqrt(squared))];
      own.factors += links.factors[link];
      own.pointing.offer(squared, sender);
      lay_across(hierarchy.nodes()[sender], to_sender, sender, looks, bins);
    }
  Row row;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    const auto& [across, pointing, factors] = bins[b];
    const float whole = std::fabs(projected[b]) / pi;
    const float factor = across.found() ? whole : std::min(factors, whole);
    if (!(factor > 0.0F)) continue;
    const bool by_middle = across.found() && (winner == BinWinner::middle || across.squared < pointing.squared);
    row.senders.push_back(by_middle ? across.sender : pointing.sender);
    row.factors.push_back(factor);
  }
  return row;
}

}  // namespace

LinkTable nearest_links(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins, BinWinner winner,
                        Task& task) {
  const auto nodes = hierarchy.nodes();
  std::vector<Row> rows(hierarchy.leaf_count());
  task.parallel_chunks(rows.size(), leaf_chunk, [&](const ChunkRange& range) {
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const auto after = std::upper_bound(hierarchy.roots().begin(), hierarchy.roots().end(), hierarchy.leaf_node(leaf));
      rows[leaf] = nearest_of(hierarchy, links, bins, winner, path_to(hierarchy, *(after - 1), static_cast<std::uint32_t>(leaf)));
    }
  });
  LinkTable table;
  table.row_begin.push_back(0);
  for (const Node& node : nodes) {
    if (node.is_leaf())
      for (std::size_t i = 0; i < rows[node.begin].senders.size(); ++i) {
        table.senders.push_back({rows[node.begin].senders[i]});
        table.factors.push_back(rows[node.begin].factors[i]);
      }
    table.row_begin.push_back(static_cast<std::uint32_t>(table.senders.size()));
  }
  return table;
}

}  // namespace gibench::antiradiance
