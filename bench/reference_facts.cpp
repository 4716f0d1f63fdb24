#include "bench/reference_facts.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gibench {

namespace {

std::optional<double> error_of(const ReferenceValues& values) {
  if (values.direct.size() == 0) return std::nullopt;
  const bool has_indirect = std::any_of(values.indirect.replicas.begin(), values.indirect.replicas.end(), [](const auto& r) {
    return std::any_of(r.begin(), r.end(), [](const Rgb& v) { return !is_black(v); });
  });
  return relative_standard_error(has_indirect ? values.indirect : Replicas::sum(values.direct, values.indirect));
}

double channel_sum(const std::vector<Rgb>& values) {
  double sum = 0.0;
  for (const Rgb& v : values) sum += static_cast<double>(v.r) + static_cast<double>(v.g) + static_cast<double>(v.b);
  return sum;
}

}  // namespace

double relative_standard_error(const Replicas& replicas) {
  if (replicas.count() < 2 || replicas.size() == 0) return 0.0;
  const double channels = 3.0 * static_cast<double>(replicas.size());
  const double mean = channel_sum(replicas.mean()) / channels;
  return mean > 0.0 ? std::sqrt(channel_sum(replicas.variance_of_mean()) / channels) / mean : 0.0;
}

double ReferenceFacts::relative_standard_error() const {
  return std::max(surface_error.value_or(0.0), image_error.value_or(0.0));
}

ReferenceFacts facts_of(const Scene& scene, const Reference& reference) {
  ReferenceFacts facts;
  facts.key = reference_key(scene, reference.question);
  facts.path_class = reference.question.path_class;
  facts.samples_per_replica = reference.samples_per_replica;
  facts.replicas = std::max(reference.surface.direct.count(), reference.image.direct.count());
  facts.seconds = reference.seconds;
  facts.surface_error = error_of(reference.surface);
  facts.image_error = error_of(reference.image);
  return facts;
}

nlohmann::ordered_json to_json(const ReferenceFacts& facts) {
  nlohmann::ordered_json json{{"samples", facts.samples_per_replica * facts.replicas},
                              {"relative_standard_error", facts.relative_standard_error()},
                              {"path_class", facts.path_class},
                              {"key", facts.key},
                              {"replicas", facts.replicas},
                              {"samples_per_replica", facts.samples_per_replica}};
  if (facts.surface_error) json["surface_relative_standard_error"] = *facts.surface_error;
  if (facts.image_error) json["image_relative_standard_error"] = *facts.image_error;
  json["seconds"] = facts.seconds;
  return json;
}

}  // namespace gibench
