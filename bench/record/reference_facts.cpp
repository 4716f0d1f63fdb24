#include "bench/record/reference_facts.h"

#include <algorithm>

#include "bench/record/json_fields.h"

#include "common/reference/scene_key.h"

namespace gibench {

namespace {

/// Of the indirect light, or of all light where there is no indirect; 0 in the dark.
std::optional<double> error_of(const ReferenceValues& values) {
  if (values.direct.size() == 0) return std::nullopt;
  if (const auto error = relative_standard_error(values.indirect)) return error;
  return relative_standard_error(Replicas::sum(values.direct, values.indirect)).value_or(0.0);
}

}  // namespace

std::string ReferenceFacts::state() const {
  const std::string surface = key + ":" + std::to_string(total_samples());
  return image_samples_per_replica ? surface + ":" + std::to_string(*image_samples_per_replica * replicas) : surface;
}

double ReferenceFacts::relative_standard_error() const {
  return std::max(surface_error.value_or(0.0), image_error.value_or(0.0));
}

ReferenceFacts facts_of(const Scene& scene, const Reference& reference) {
  ReferenceFacts facts;
  facts.key = reference_key(scene, reference.question);
  facts.path_class = reference.question.path_class;
  facts.samples_per_replica = reference.samples_per_replica;
  if (reference.question.camera && reference.image_samples_per_replica != reference.samples_per_replica)
    facts.image_samples_per_replica = reference.image_samples_per_replica;
  facts.replicas = std::max(reference.surface.direct.count(), reference.image.direct.count());
  facts.seconds = reference.seconds;
  facts.surface_error = error_of(reference.surface);
  facts.image_error = error_of(reference.image);
  return facts;
}

nlohmann::ordered_json to_json(const ReferenceFacts& facts) {
  nlohmann::ordered_json json{{"samples", facts.total_samples()}, {"relative_standard_error", facts.relative_standard_error()},
                              {"path_class", facts.path_class},   {"key", facts.key},
                              {"replicas", facts.replicas},       {"samples_per_replica", facts.samples_per_replica}};
  if (facts.image_samples_per_replica) json["image_samples_per_replica"] = *facts.image_samples_per_replica;
  if (facts.surface_error) json["surface_relative_standard_error"] = *facts.surface_error;
  if (facts.image_error) json["image_relative_standard_error"] = *facts.image_error;
  json["seconds"] = facts.seconds;
  return json;
}

ReferenceFacts reference_facts_of(const nlohmann::ordered_json& json) {
  ReferenceFacts facts;
  read_field(json, "path_class", facts.path_class);
  read_field(json, "key", facts.key);
  read_field(json, "replicas", facts.replicas);
  read_field(json, "samples_per_replica", facts.samples_per_replica);
  read_field(json, "image_samples_per_replica", facts.image_samples_per_replica);
  read_field(json, "surface_relative_standard_error", facts.surface_error);
  read_field(json, "image_relative_standard_error", facts.image_error);
  read_field(json, "seconds", facts.seconds);
  return facts;
}

}  // namespace gibench
