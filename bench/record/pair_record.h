/// The terms of a run's errors, pairs.cbor, by which it is compared with other runs against the same reference.
///
/// CBOR (RFC 8949): {"gibench_pairs": 2, "reference": {"key", "samples_per_replica", "replicas"}, "errors": component → domain →
/// metric → {"value", "influences", "parts", "seeds", "point_noise", "mean", "correction", "least_share"}}, `parts` as bytes of
/// 32-bit floats, little-endian (common/metrics/pair_terms.h says what they are).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "common/effects/component.h"
#include "common/metrics/domain.h"
#include "common/metrics/pair_terms.h"

namespace gibench {

inline constexpr const char* pair_file = "pairs.cbor";

/// Of each of paired_metrics that is defined.
using MetricPairs = std::map<std::string, PairTerms>;
using ComponentPairs = std::map<Component, std::map<Domain, MetricPairs>>;

/// The terms of one run, and what they were taken against.
struct PairRecord {
  std::string reference_key;  ///< hash of scene, light paths, seed and points
  std::uint64_t samples_per_replica = 0, replicas = 0;
  ComponentPairs errors;

  /// Null where it was not measured.
  const PairTerms* terms(Component component, Domain domain, const std::string& metric) const;
};

/// Whether both were taken against the same paths at the same points.
bool can_be_compared(const PairRecord& a, const PairRecord& b);

/// The bytes of the file.
std::string to_cbor(const PairRecord& record);
/// Throws InputError that names the file.
PairRecord read_pair_record(const std::filesystem::path& file);

}  // namespace gibench
