/// The record of a checked scene, as `gibench check --json` prints it: written and read here.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/effect_record.h"
#include "bench/record/picture_record.h"
#include "common/effects/scene_facts.h"
#include "common/geometry/geometry_report.h"
#include "common/ray/coincident_faces.h"
#include "common/spaces/space_report.h"

namespace gibench {

/// What a scene is and calls for.
struct SceneAnalysis {
  std::string key;
  GeometryReport geometry;
  std::vector<EffectEvidence> effects;
  BoundRecord bounce_bound;
  double seconds = 0.0;  ///< that the analysis of its effects took
};

/// A method's plan on a scene, and the light paths that it means.
struct PlanRecord {
  std::string method;
  EffectPlan plan;
  std::string light_paths;
  bool complete = false;               ///< all that the scene has
  std::optional<std::string> refusal;  ///< why it cannot work on the scene
};

struct CheckRecord {
  std::string scene, file;
  SceneAnalysis analysis;
  CoincidenceCounts coincident;  ///< pairs of triangles
  SpaceReport spaces;            ///< its warnings stand below
  std::vector<MeasuredCamera> cameras;
  std::size_t lights = 0;
  std::vector<std::string> warnings;
  LightCounts light_kinds;  ///< of the lights that reach a surface
  std::string changes;      ///< what the scene's edits change, in words
  std::vector<PlanRecord> methods;
  std::optional<Exposure> exposure;  ///< that the scene states
};

nlohmann::ordered_json to_json(const CheckRecord& record);
/// Throws nlohmann::json::exception or InputError for anything but a record.
CheckRecord check_record_of(const nlohmann::ordered_json& json);

}  // namespace gibench
