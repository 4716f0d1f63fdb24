/// The mesh as a graph: which vertices are neighbours, and how much of the Laplacian lies between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "methods/spectral/interpolation.h"

namespace gibench::spectral {

/// Symmetric compressed rows. Edges that another surface cuts are left out, so that no basis function reaches through
/// a wall that stands on a floor.
struct SurfaceGraph {
  std::vector<std::uint32_t> begin;      ///< into the arrays below; one more than vertices
  std::vector<std::uint32_t> neighbour;  ///< ascending in every row
  std::vector<double> cotan;             ///< ½ (cot α + cot β) of the angles opposite the edge, held within bounds, > 0
  std::vector<double> area;              ///< m², of every vertex

  std::size_t size() const { return area.size(); }
  std::span<const std::uint32_t> neighbours(std::uint32_t vertex) const {
    return std::span(neighbour).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

SurfaceGraph make_graph(const SamplingMesh& mesh, const Interpolation& interpolation);

}  // namespace gibench::spectral
