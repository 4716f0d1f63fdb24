/// The record of a run, result.json, written and read here. Unmeasured values are omitted, not written as zero.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/checksums.h"
#include "bench/record/effect_record.h"
#include "bench/record/machine.h"
#include "bench/record/picture_record.h"
#include "bench/record/reference_facts.h"
#include "bench/record/stage.h"
#include "common/effects/component.h"
#include "common/method/parameters.h"
#include "common/method/stage_report.h"
#include "common/metrics/domain.h"
#include "common/metrics/errors.h"

namespace gibench {

using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

inline constexpr const char* result_file = "result.json";

struct StageRecord {
  Stage stage = Stage::prepare;  ///< or light, shade_surface, shade_image
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

/// Where a method was asked.
struct MeasuredAt {
  std::size_t surface_samples = 0;
  std::uint64_t reference_seed = 1;      ///< of the surface samples, the camera rays and the reference
  std::optional<MeasuredCamera> camera;  ///< empty: no pictures
  int pixel_samples = 0;                 ///< camera rays per pixel
  std::string surface_domain;            ///< of the surface samples: seen, all, whole or names of objects
  std::optional<double> sealed_share;    ///< of the area, left out of `all`
};

struct RunRecord {
  std::string scene, method;
  ParameterValues parameters;
  std::uint64_t seed = 1;
  int threads = 1;
  Origin origin;
  MeasuredAt measured_at;
  EffectPlan plan;
  std::string light_paths;           ///< what it computes under the plan
  bool complete = false;             ///< all paths of the scene
  std::vector<Component> completed;  ///< what the shared evaluator answered for the method
  double load_seconds = 0.0;         ///< reading the scene and building the ray backend
  std::vector<StageRecord> stages;
  std::size_t method_bytes = 0;  ///< 0: unknown
  std::uint64_t peak_bytes = 0;  ///< of the process until its answers were there; 0: unknown
  Counters counters;
  std::vector<std::string> warnings;
  std::optional<Exposure> exposure;  ///< at which its pictures are shown and FLIP was taken
  ComponentErrors errors;
  std::vector<std::uint64_t> method_seeds;  ///< over which the errors were taken; empty: `seed` alone
  /// Whether the method's own noise is independent between points, so that it is among what intervals cover with the points.
  bool noise_of_points = false;
  FileChecksums files;                      ///< beside the record: pairs.cbor
  std::optional<ReferenceFacts> reference;  ///< what the errors were taken against
  std::optional<ErrorSplit> split;          ///< where it has not all paths, and both references are there
  std::vector<BounceErrors> per_bounce;
};

/// What the intervals of its errors cover: "reference", "points", and "method_seed" where the method was run with several, or
/// its noise is one of the points.
std::vector<std::string> covered_by_intervals(const RunRecord& record);
/// How the run ended: by the first stage that says more than "done".
Termination termination_of(const RunRecord& record);
/// Seconds of loading, of each stage and, where it was asked, of `shade`: its stages together.
std::vector<std::pair<Stage, double>> seconds_of(const RunRecord& record);

nlohmann::ordered_json to_json(const RunRecord& record);
/// Throws nlohmann::json::exception or InputError for what is not a record.
RunRecord run_record_of(const nlohmann::ordered_json& json);
/// Throws InputError that names the file.
RunRecord read_run_record(const std::filesystem::path& file);

nlohmann::ordered_json to_json(const ErrorTable& table);
ErrorTable error_table_of(const nlohmann::ordered_json& json);
nlohmann::ordered_json to_json(const ParameterValue& value);
nlohmann::ordered_json to_json(const ParameterValues& values);
ParameterValues parameters_of(const nlohmann::ordered_json& json);

}  // namespace gibench
