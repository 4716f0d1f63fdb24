/// Replicates in few bits: as many of every number as its own noise leaves meaning.
///
/// Each channel of each value has a step Δ in (g σ, 2 g σ], where σ is the standard deviation of its replicates and g the grain,
/// and at least g 2^-11 of its mean (for g = 1 the precision of a 16-bit float): a power of two times g. A replicate x is kept as
/// the whole number n = floor(x/Δ + u + 1/2) and read back as (n − u) Δ, with a known u, uniform in [-1/2, 1/2) and different for
/// every number (subtractive dither, Roberts 1962). What is read back then differs from x by an error uniform in [-Δ/2, Δ/2],
/// independent from number to number, whatever x is: estimates from halves and replicates keep no bias, and the variance of a
/// replicate grows by Δ²/12: for g = 1 by 1/12 to 1/3 of its own, for g = 1.5 by 1/5 to 3/4. Where all replicates are 0, they
/// stay 0.
#pragma once

#include <string>
#include <string_view>

#include "common/metrics/replicas.h"

namespace gibench {

/// How much is kept: the least step in standard deviations.
enum class Grain : char { fine = 2, coarse = 3 };  ///< g = 1 and 1.5, in halves

/// Deflated bytes. At most 16 replicates, all finite.
std::string pack_replicas(const Replicas& replicas, Grain grain);

/// What pack_replicas made of `count` replicates of `size` values; empty where the bytes are not of that.
Replicas unpack_replicas(std::string_view bytes, std::size_t count, std::size_t size);

/// The most replicates that can be packed.
inline constexpr std::size_t most_packed_replicas = 16;

}  // namespace gibench
