/// Replicates in a file: 32 bytes of header ("GIBREPL1", replicates, values, checksum, each 64-bit little-endian), then the
/// floats r, g, b of every value of every replicate. The checksum is XXH3 of the two counts and all that follows the header.
/// Packed files begin with "GIBREPL2", and what follows the header is that of packed_replicas.h.
#pragma once

#include <cstdint>
#include <filesystem>

#include "common/metrics/replicas.h"

namespace gibench {

/// Whether all bits are kept or those that mean something, in fine or coarse grain (packed_replicas.h).
enum class ReplicaFormat { exact, packed, packed_coarsely };

/// Writes the file whole or not at all; returns its checksum.
std::uint64_t write_replicas(const std::filesystem::path& file, const Replicas& replicas,
                             ReplicaFormat format = ReplicaFormat::exact);

/// DamagedReference with the file's name if it is missing, truncated, changed, not of this format, holds a value that is not
/// finite, or is another file than the one with `checksum`.
Replicas read_replicas(const std::filesystem::path& file, std::uint64_t checksum);

}  // namespace gibench
