#include "methods/antiradiance/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "methods/antiradiance/bin_transport.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 64;

struct Nearest {
  float squared = std::numeric_limits<float>::infinity();
  float factors = 0.0F;
  std::uint32_t sender = 0;
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

Row nearest_of(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins,
               const std::vector<std::uint32_t>& path) {
  const Node& leaf = hierarchy.nodes()[path.back()];
  std::vector<float> projected(bins.count());
  projected_bins(bins, leaf.normal, projected);
  std::vector<Nearest> nearest(bins.count());
  for (const std::uint32_t node : path)
    for (std::uint32_t link = links.row_begin[node]; link < links.row_begin[node + 1]; ++link) {
      const std::uint32_t sender = links.senders[link].node();
      const Vec3 way = leaf.centre - hierarchy.nodes()[sender].centre;
      const float squared = glm::dot(way, way);
      if (!(squared > 0.0F)) continue;
      const DirectionBins::Place place = bins.place(way / std::sqrt(squared));
      const auto largest = std::max_element(place.shares.begin(), place.shares.end()) - place.shares.begin();
      Nearest& bin = nearest[bins.bins_of(place.quad)[static_cast<std::size_t>(largest)]];
      bin.factors += links.factors[link];
      if (squared < bin.squared) bin.squared = squared, bin.sender = sender;
    }
  Row row;
  for (std::size_t b = 0; b < bins.count(); ++b)
    if (nearest[b].factors > 0.0F) {
      row.senders.push_back(nearest[b].sender);
      row.factors.push_back(std::min(nearest[b].factors, std::fabs(projected[b]) / pi));
    }
  return row;
}

}  // namespace

LinkTable nearest_links(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins, Task& task) {
  const auto nodes = hierarchy.nodes();
  std::vector<Row> rows(hierarchy.leaf_count());
  task.parallel_chunks(rows.size(), leaf_chunk, [&](const ChunkRange& range) {
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const auto after = std::upper_bound(hierarchy.roots().begin(), hierarchy.roots().end(), hierarchy.leaf_node(leaf));
      rows[leaf] = nearest_of(hierarchy, links, bins, path_to(hierarchy, *(after - 1), static_cast<std::uint32_t>(leaf)));
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
