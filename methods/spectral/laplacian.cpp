#include "methods/spectral/laplacian.h"

#include <algorithm>
#include <vector>

namespace gibench::spectral {

SymmetricLaplacian symmetric_laplacian(const SurfaceGraph& graph, std::span<const std::uint32_t> vertices, Laplacian kind,
                                       double mean_area) {
  const auto size = static_cast<Eigen::Index>(vertices.size());
  std::vector<Eigen::Triplet<double>> entries;
  SymmetricLaplacian laplacian{Eigen::SparseMatrix<double>(size, size), Eigen::VectorXd::Ones(size)};
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const std::uint32_t vertex = vertices[static_cast<std::size_t>(i)];
    double valence = 0.0;
    for (std::uint32_t e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e) {
      const auto found = std::lower_bound(vertices.begin(), vertices.end(), graph.neighbour[e]);
      if (found == vertices.end() || *found != graph.neighbour[e]) continue;
      const double weight = kind == Laplacian::cotan ? graph.cotan[e] : 1.0;
      entries.emplace_back(i, found - vertices.begin(), -weight);
      diagonal[i] += weight;
      valence += 1.0;
    }
    // A single vertex has the constant function only, with any weight above zero.
    if (kind == Laplacian::cotan) laplacian.weight[i] = graph.area[vertex] / mean_area;
    else if (valence > 0.0) laplacian.weight[i] = valence;
  }
  for (Eigen::Index i = 0; i < size; ++i) entries.emplace_back(i, i, diagonal[i]);
  laplacian.matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd root = laplacian.weight.cwiseSqrt().cwiseInverse();
  laplacian.matrix = root.asDiagonal() * laplacian.matrix * root.asDiagonal();
  return laplacian;
}

}  // namespace gibench::spectral
