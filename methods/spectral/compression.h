/// The threshold below which the transfer matrix is truncated, chosen by the effect on trial lights.
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/transfer_matrix.h"
#include "methods/spectral/trial_lights.h"

namespace gibench::spectral {

/// A block of rows as they would be if nothing were left out, dense, one behind the other.
struct PilotBlock {
  std::vector<float> rows;
  std::vector<float> others[2];  ///< the same by other rays, independent; empty: the rows are exact
  std::vector<double> areas;     ///< that the rows stand for, m²
};

/// The numbers of the blocks among `blocks` that are to be pilots, spread evenly.
std::vector<std::size_t> pilot_blocks(std::size_t blocks);

/// The truncation that changes the pilots' answers by `error` as a share of them: root of the mean over lights of the mean square
/// over area. Judged by what it does to the truth: columns are those that the pilots' rows keep, and the mean square change of
/// the true rows is that of one set of other rays times that of the other, so that dropping what is but the rays' noise costs
/// nothing. Columns count by how much light they usually carry, the root mean square coefficient of functions of that order in
/// their parts, or their own where that is more, so that what is left out counts the same wherever it is.
Truncation choose_truncation(const SpectralBasis& basis, const TrialLights& lights, std::span<const PilotBlock> pilots,
                             double error, Task& task);

}  // namespace gibench::spectral
