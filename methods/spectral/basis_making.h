/// The making of the spectral mesh basis: the eigenvectors of every part's Laplacian.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/method/task.h"
#include "methods/spectral/basis.h"
#include "methods/spectral/laplacian.h"

namespace gibench::spectral {

/// How making a basis went; the basis counts where `failure` is empty.
struct BasisMaking {
  SpectralBasis basis;
  std::string failure;  ///< one line that names the part
  std::uint32_t dense_parts = 0, failed_attempts = 0;
};

/// `functions`: how many of each part.
BasisMaking make_basis(const SurfaceGraph& graph, const Partition& partition, const std::vector<std::uint32_t>& functions,
                       Laplacian kind, Task& task);

}  // namespace gibench::spectral
