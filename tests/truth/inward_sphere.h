/// A tessellated sphere seen from inside, made here because its file would be large.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace gibench::truth {

/// `sphere`: {"name", "material", "radius" (metres), "rows", "columns"}, about the origin. Returns an object of a scene
/// file; the vertices lie a little outside the sphere, so that the mean distance of the faces is its radius.
nlohmann::json inward_sphere(const nlohmann::json& sphere);

}  // namespace gibench::truth
