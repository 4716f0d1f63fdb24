/// The camera of a record's pictures and the exposure at which they are shown, as records write and read them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "common/image/exposure.h"

namespace gibench {

struct MeasuredCamera {
  std::string name;
  int width = 0, height = 0;  ///< pixels
};

/// Adds the name, under `name_key`, and resolution: [width, height].
void write_camera(nlohmann::ordered_json& json, const MeasuredCamera& camera, const char* name_key = "camera");
/// Empty where there is no name.
std::optional<MeasuredCamera> camera_in(const nlohmann::ordered_json& json, const char* name_key = "camera");

/// Adds exposure: {value, start, stop}, in stops, where there is one.
void write_exposure(nlohmann::ordered_json& json, const std::optional<Exposure>& exposure);
std::optional<Exposure> exposure_in(const nlohmann::ordered_json& json);

}  // namespace gibench
