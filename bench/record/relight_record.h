/// What `gibench relight` records: every frame's cost and errors, and what relighting is worth beside path tracing.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/relight_economics.h"
#include "common/effects/component.h"
#include "common/method/stage_report.h"

namespace gibench {

/// One relit frame: its cost, and its errors where a reference was asked for.
struct RelitFrame {
  double at = 0.0;
  std::vector<std::string> switched;  ///< names of materials
  double relight_seconds = 0.0, shade_seconds = 0.0;
  Termination termination = Termination::done;
  std::map<Component, ErrorTable> errors;
  std::optional<PathTraced> reference;  ///< its indirect light, W/m²
  Bounded path_tracing;                 ///< seconds to the same indirect error
};

nlohmann::ordered_json relit_frame_json(const RelitFrame& frame);
/// Medians over the frames, one at least; what path tracing takes for their error where they were compared.
nlohmann::ordered_json relight_summary_json(double prepare_seconds, const std::vector<RelitFrame>& frames);

}  // namespace gibench
