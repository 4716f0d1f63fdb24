/// The mesh as a graph of its nodes: which are neighbours, and how much of the Laplacian lies between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "methods/spectral/interpolation.h"
#include "methods/spectral/nodes.h"

namespace gibench::spectral {

/// An edge that is put in where the mesh has none.
struct AddedEdge {
  std::uint32_t from, to;
  double cotan;
};

/// Symmetric compressed rows. Edges that another surface cuts are left out, so that no basis function reaches through
/// a wall that stands on a floor.
struct SurfaceGraph {
  std::vector<std::uint32_t> begin;      ///< into the arrays below; one more than nodes
  std::vector<std::uint32_t> neighbour;  ///< ascending in every row
  std::vector<double> cotan;             ///< ½ (cot α + cot β) of the angles opposite the edge, held within bounds, > 0
  std::vector<double> area;              ///< m², of every node

  std::size_t size() const { return area.size(); }
  std::span<const std::uint32_t> neighbours(std::uint32_t node) const {
    return std::span(neighbour).subspan(begin[node], begin[node + 1] - begin[node]);
  }
  /// Without the edges for which leave_out(from, to) says true both ways.
  template <class LeaveOut>
  void thin(const LeaveOut& leave_out);
  /// With more edges, both ways; none of them is there yet.
  void add(std::span<const AddedEdge> edges);
};

/// Between two clusters lies the sum over the mesh's edges that cross from one to the other, each times its length over the
/// distance of the clusters: m edges of length h side by side between squares of m × m vertices, m h apart, weigh as one. That
/// edge is cut where all of them are; one between single vertices where it is seen to be from either side.
SurfaceGraph make_graph(const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes);

template <class LeaveOut>
void SurfaceGraph::thin(const LeaveOut& leave_out) {
  std::size_t kept = 0;
  std::uint32_t first = 0;
  for (std::uint32_t node = 0; node < size(); ++node) {
    const std::uint32_t end = begin[node + 1];
    for (std::uint32_t e = first; e < end; ++e) {
      if (leave_out(node, neighbour[e])) continue;
      neighbour[kept] = neighbour[e];
      cotan[kept++] = cotan[e];
    }
    first = end;
    begin[node + 1] = static_cast<std::uint32_t>(kept);
  }
  neighbour.resize(kept);
  cotan.resize(kept);
}

/// The connected pieces of a graph.
struct Pieces {
  std::vector<std::uint32_t> of_node;
  std::uint32_t count = 0;
};

/// Numbers the connected pieces of the nodes that share a label.
Pieces connected_pieces(const SurfaceGraph& graph, std::span<const std::uint32_t> label);

}  // namespace gibench::spectral
