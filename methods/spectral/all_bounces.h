/// T*: all bounces folded into the transfer matrix, for albedos that do not change (Wang et al. 2007, section 3.2).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/method/stage_report.h"
#include "methods/spectral/basis.h"
#include "methods/spectral/compression.h"
#include "methods/spectral/transfer_matrix.h"

namespace gibench::spectral {

/// Columns up to which bounces are folded: a dense matrix of so many is made, in double precision, and inverted.
inline constexpr std::uint64_t most_folded_columns = 8192;

/// What is to be folded.
struct FoldingWish {
  std::span<const Rgb4> reflectance;  ///< ρ/π of every slot, 1/sr
  std::span<const double> areas;      ///< of every slot, m²
  int most_bounces = 0;               ///< 0: all
  bool keep_light = false;            ///< G itself is wanted, too
};

/// One matrix of each kind where all surfaces are grey, else one per channel; empty where the series has no sum.
struct Folding {
  std::vector<TransferMatrix> irradiance;  ///< T*
  std::vector<std::vector<float>> light;   ///< G, dense, row by row
  Termination termination = Termination::done;
  std::string message;  ///< why there is none, or how far an error of the matrix is multiplied
};

/// With B = S R T^s, the light of one bounce from basis to basis (S the projection, R the reflectances ρ/π), the light of all is
/// c = c₀ + B c₀ + B² c₀ + … = G c₀, and the irradiance T^s G c₀: T* = T^s G. G is the series of `most_bounces` terms where that
/// is given (> 0), else (1 − B)⁻¹, which is the sum of the series only where the spectral radius of B is below one: where the
/// slowest light loses less than a thousandth at a bounce, the rounding of T^s decides the sum, and none is given. Compressed as
/// T^s was, on rows of its own.
Folding fold_bounces(const SpectralBasis& basis, const TransferMatrix& one_bounce, const FoldingWish& wish,
                     const CompressionWish& compression, Task& task);

}  // namespace gibench::spectral
