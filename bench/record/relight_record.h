/// The record of `gibench relight`: cost and errors of every frame, and relighting compared with path tracing.
/// relight.json, written and read here.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/relight_economics.h"
#include "bench/record/run_record.h"
#include "common/effects/component.h"
#include "common/method/stage_report.h"

namespace gibench {

inline constexpr const char* relight_file = "relight.json";

/// One relit frame: its cost, and its errors where a reference was asked for.
struct RelitFrame {
  double at = 0.0;                    ///< 0 for the first, 1 for the last
  std::vector<std::string> switched;  ///< names of materials
  double relight_seconds = 0.0, shade_seconds = 0.0;
  Termination termination = Termination::done;
  std::map<Component, ErrorTable> errors;  ///< at the surface samples
  std::optional<PathTraced> reference;     ///< its indirect light, W/m²
  Bounded path_tracing;                    ///< seconds to the same indirect error
};

/// Medians over the frames; what path tracing takes for their error where they were compared.
struct RelightSummary {
  std::size_t frames = 0;
  double prepare_seconds = 0.0;
  double relight_seconds = 0.0, shade_seconds = 0.0;
  std::optional<Bounded> path_tracing_seconds;  ///< to a frame's error in the indirect light
  std::optional<Bounded> times_cheaper;         ///< than path tracing
  std::optional<Bounded> frames_that_pay;       ///< for preparing
};
/// Of one frame at least.
RelightSummary summarise(double prepare_seconds, const std::vector<RelitFrame>& frames);

struct RelightRecord {
  std::string scene, method;
  std::uint64_t seed = 1;
  ParameterValues parameters;
  std::vector<RelitFrame> frames;
  RelightSummary summary;
};

nlohmann::ordered_json to_json(const RelightRecord& record);
/// Throws InputError that names the file.
RelightRecord read_relight_record(const std::filesystem::path& file);

}  // namespace gibench
