/// Vectors, colours and exposures of a scene file, from their JSON. The JSON was validated against the schema before.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "common/image/exposure.h"
#include "common/json/json_place.h"

namespace gibench {

/// Three numbers.
Vec3d read_vector(const nlohmann::json& value);
/// `object[key]` as three numbers, or `fallback` where it is absent.
Vec3d vector_or(const nlohmann::json& object, const char* key, const Vec3d& fallback);
/// A number or three, as three.
Vec3d read_triple(const nlohmann::json& value);
/// A number or three channels; InputError where single precision cannot hold it.
Rgb read_rgb(const nlohmann::json& value, const JsonPlace& place);
/// Unit vector; InputError where all its components are 0.
Vec3d read_direction(const nlohmann::json& value, const JsonPlace& place);
/// InputError where start is not below stop.
Exposure read_exposure(const nlohmann::json& exposure, const JsonPlace& place);

}  // namespace gibench
