/// The threshold below which the transfer matrix is truncated, chosen by the effect on trial lights.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/settings.h"
#include "methods/spectral/transfer_matrix.h"
#include "methods/spectral/trial_lights.h"

namespace gibench::spectral {

/// A block of rows as they would be if nothing were left out, dense, one behind the other.
struct PilotBlock {
  std::vector<float> rows;
  std::vector<float> others[2];  ///< the same by other rays, independent; empty: the rows are exact
  std::vector<double> areas;     ///< that the rows stand for, m²
};

/// The numbers of the blocks among `blocks` that are to be pilots, `most` at most, spread evenly.
std::vector<std::size_t> pilot_blocks(std::size_t blocks, std::size_t most = 64);

/// The truncation that changes the pilots' answers by `error` as a share of them: root of the mean over lights of the mean square
/// over area. Judged by what it does to the truth: columns are those that the pilots' rows keep, and the mean square change of
/// the true rows is that of one set of other rays times that of the other, so that dropping what is but the rays' noise costs
/// nothing. Columns count by how much light they usually carry, the root mean square coefficient of functions of that order in
/// their parts, or their own where that is more, so that what is left out counts the same wherever it is.
Truncation choose_truncation(const SpectralBasis& basis, const TrialLights& lights, std::span<const PilotBlock> pilots,
                             double error, Task& task);

/// How the matrices of a transfer are compressed.
struct CompressionWish {
  Compression kind = Compression::judged;
  double error = 0.0;  ///< 0 in kind `judged`: nothing is left out
  TrialLights lights;  ///< that judge, where they are asked for

  bool judged() const { return kind == Compression::judged && error > 0.0; }
};

/// As wished; `pilots` are made only where the truncation is judged by them. Nothing is left out of the matrices of a run that is
/// cancelled, whose pilots may have no rows.
Truncation truncation_for(const CompressionWish& wish, const SpectralBasis& basis,
                          const std::function<std::vector<PilotBlock>()>& pilots, Task& task);

}  // namespace gibench::spectral
