/// What one run tells: result.json. What was not measured is absent, never zero.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/reference_facts.h"
#include "common/effects/component.h"
#include "common/effects/effect_plan.h"
#include "common/method/parameters.h"
#include "common/method/stage_report.h"
#include "common/metrics/domain.h"
#include "common/metrics/errors.h"
#include "common/reference/reference_store.h"

namespace gibench {

using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

struct StageRecord {
  std::string stage;  ///< prepare, light, shade_surface, shade_image
  StageReport report;
};

using DomainErrors = std::map<Domain, ErrorTable>;
using ComponentErrors = std::map<Component, DomainErrors>;

/// Total error in two: what the method's light paths lack, and what its discretisation adds on those paths.
struct ErrorSplit {
  ComponentErrors model;           ///< the reference of its paths against that of all paths
  ComponentErrors discretisation;  ///< the method against the reference of its paths
  ReferenceFacts reference;        ///< the one of its paths
};

/// Both of them for the light of one number of reflections between a light and the surface asked about.
struct BounceErrors {
  int bounce = 0;
  std::optional<ComponentErrors> model;  ///< empty: the method has all paths of this bounce
  ComponentErrors discretisation;
};

struct RunRecord {
  std::string scene, method;
  ParameterValues parameters;
  std::uint64_t seed = 1;
  int threads = 1;
  ReferenceQuestion question;  ///< where the method was asked, and for which paths
  EffectPlan plan;
  std::string light_paths;           ///< what it computes under the plan
  bool complete = false;             ///< all paths of the scene
  std::vector<Component> completed;  ///< what the shared evaluator answered for the method
  double load_seconds = 0.0;         ///< reading the scene and building the ray backend
  std::vector<StageRecord> stages;
  std::size_t method_bytes = 0;  ///< 0: unknown
  Counters counters;
  std::vector<std::string> warnings;
  std::optional<Exposure> exposure;  ///< at which its pictures are shown and FLIP was taken
  ComponentErrors errors;
  std::optional<ReferenceFacts> reference;  ///< what the errors were taken against
  std::optional<ErrorSplit> split;          ///< where it has not all paths, and both references are there
  std::vector<BounceErrors> per_bounce;
};

/// As DESIGN names the fields; peak memory and machine are those of this process.
nlohmann::ordered_json to_json(const RunRecord& record);

nlohmann::ordered_json to_json(const ErrorTable& table);
/// {called_for, simulated, missing, skipped: [{effect, why}]}
nlohmann::ordered_json to_json(const EffectPlan& plan);
nlohmann::ordered_json to_json(const ParameterValue& value);
/// {value, start, stop} in stops
nlohmann::ordered_json to_json(const Exposure& exposure);

}  // namespace gibench
