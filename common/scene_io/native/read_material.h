/// Materials of a scene file, from their JSON. The JSON was validated against the schema before.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/json/json_place.h"
#include "common/scene/scene.h"

namespace gibench {

/// InputError where the surface would reflect more than it gets.
Material read_material(const nlohmann::json& material, const std::string& name, const JsonPlace& place);
/// `before` with the given keys changed; with another bsdf everything but the emission starts anew. InputError also for
/// a key that the material does not have.
Material edited_material(const nlohmann::json& edit, const Material& before, const JsonPlace& place);

}  // namespace gibench
