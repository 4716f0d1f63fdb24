/// The two Laplacians of a submesh, in symmetric form.
#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "methods/spectral/settings.h"
#include "methods/spectral/surface_graph.h"

namespace gibench::spectral {

/// A Laplacian W⁻¹ K, K symmetric, is self-adjoint in ⟨f, g⟩ = Σ wᵢ fᵢ gᵢ. Its eigenvectors are W^(−1/2) y, where y are those of
/// the symmetric W^(−1/2) K W^(−1/2), and are orthonormal in that product where the y are.
///
/// `graph` (Wang et al. 2007, 3.1): K = D − A, W = D the valences, so that W⁻¹ K has 1 on its diagonal and −1/dᵢ beside it.
/// `cotan`: K from cotangent weights, W the vertices' areas over their mean.
struct SymmetricLaplacian {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd weight;  ///< wᵢ > 0
};

/// Of the vertices of one part (ascending), edges to others left out. `mean_area` in m², of a vertex of the whole mesh.
SymmetricLaplacian symmetric_laplacian(const SurfaceGraph& graph, std::span<const std::uint32_t> vertices, Laplacian kind,
                                       double mean_area);

}  // namespace gibench::spectral
