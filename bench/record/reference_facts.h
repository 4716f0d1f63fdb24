/// The quality of a stored reference in a few numbers.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "common/reference/reference_store.h"

namespace gibench {

struct ReferenceFacts {
  std::string key, path_class;
  std::uint64_t samples_per_replica = 0;                   ///< paths for each value in each replicate
  std::optional<std::uint64_t> image_samples_per_replica;  ///< for each pixel, where they are other ones
  std::size_t replicas = 0;
  double seconds = 0.0;  ///< spent on making it
  /// Of the indirect light (of all light where there is no indirect); absent where nothing was asked there.
  std::optional<double> surface_error, image_error;

  /// Paths for each value in all, over replicates.
  std::uint64_t total_samples() const { return samples_per_replica * replicas; }
  /// Key and paths, "KEY:PATHS", or "KEY:PATHS:PATHS" where pixels have other numbers of them: another state gives other errors.
  std::string state() const;
  /// The larger of the two.
  double relative_standard_error() const;
};

/// Name of the entry beside the facts that `gibench reference` prints where it made a damaged reference anew: what was damaged.
inline constexpr const char* remade_key = "remade";

ReferenceFacts facts_of(const Scene& scene, const Reference& reference);

/// {key, path_class, samples (per value, in all, over replicates), samples_per_replica, replicas, relative_standard_error, …}
nlohmann::ordered_json to_json(const ReferenceFacts& facts);
ReferenceFacts reference_facts_of(const nlohmann::ordered_json& json);

}  // namespace gibench
