/// Submeshes: METIS over the graph of the mesh (Wang et al. 2007, section 3.3, figure 3).
#pragma once

#include <cstdint>
#include <vector>

#include "methods/spectral/surface_graph.h"

namespace gibench::spectral {

/// Every part is connected: the connected pieces of the graph are each cut into parts of about the wanted
/// size, and what METIS leaves in two pieces becomes two parts. A node without neighbours is a part.
struct Partition {
  std::vector<std::uint32_t> order;       ///< nodes, part by part, ascending in each as partition_mesh() leaves them
  std::vector<std::uint32_t> part_begin;  ///< into order; one more than parts

  std::size_t parts() const { return part_begin.size() - 1; }
  std::uint32_t part_size(std::size_t part) const { return part_begin[part + 1] - part_begin[part]; }
};

Partition partition_mesh(const SurfaceGraph& graph, std::uint32_t part_vertices);

/// `total` basis functions shared out over the parts by their nodes: at least one, at most one per node.
std::vector<std::uint32_t> share_out(const Partition& partition, std::uint32_t total);
/// The same by those of their nodes that light reaches: what is dark needs but one.
std::vector<std::uint32_t> share_out(const Partition& partition, std::uint32_t total, const Nodes& nodes);

}  // namespace gibench::spectral
