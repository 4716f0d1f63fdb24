/// How much the transfer matrix may leave out: chosen from what that does to light that is tried out.
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/transfer_matrix.h"

namespace gibench::spectral {

/// A block of rows as they would be if nothing were left out, dense, one behind the other.
struct PilotBlock {
  std::vector<float> rows;
  std::vector<float> others[2];  ///< the same by other rays, independent; empty: the rows are exact
  std::vector<double> areas;     ///< that the rows stand for, m²
};

/// The numbers of the blocks among `blocks` that are to be pilots, spread evenly.
std::vector<std::size_t> pilot_blocks(std::size_t blocks);

/// The truncation by which compression adds `error` to the error of the pilots' answers to a trial light, as a share of them
/// (root of the mean square over area), to the worst of them. The squared error of x is (x − A)(x − B), A and B by independent
/// rays: against the truth, so that dropping what is but the rays' noise adds nothing. Columns count by how much light they
/// usually carry, the root mean square coefficient of functions of that order in their parts, or their own where that is more, so
/// that what is left out adds about the same wherever it is.
Truncation choose_truncation(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights,
                             std::span<const PilotBlock> pilots, double error, Task& task);

}  // namespace gibench::spectral
