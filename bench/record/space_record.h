/// The report on the sides of a scene's surfaces as JSON: a part of the record of a checked scene.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/spaces/space_report.h"

namespace gibench {

/// All but the warnings, which stand among those of the record.
nlohmann::ordered_json to_json(const SpaceReport& report);
/// Throws nlohmann::json::exception for what is none.
SpaceReport space_report_of(const nlohmann::ordered_json& json);

}  // namespace gibench
