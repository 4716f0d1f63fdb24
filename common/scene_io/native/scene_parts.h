/// The parts of a scene file, each from its JSON to the scene in memory. The JSON was validated against the schema
/// before; what the schema cannot say is checked here. All throw InputError with place, problem and mend.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "common/json/json_place.h"
#include "common/scene/scene_builder.h"

namespace gibench {

// Values ------------------------------------------------------------------------------------------------------------

/// Three numbers.
Vec3d read_vector(const nlohmann::json& value);
/// `object[key]` as three numbers, or `fallback` where it is absent.
Vec3d vector_or(const nlohmann::json& object, const char* key, const Vec3d& fallback);
/// A number or three, as three.
Vec3d read_triple(const nlohmann::json& value);
/// A number or three channels; an error where single precision cannot hold it.
Rgb read_rgb(const nlohmann::json& value, const JsonPlace& place);
/// Unit vector; an error where all its components are 0.
Vec3d read_direction(const nlohmann::json& value, const JsonPlace& place);

// Parts -------------------------------------------------------------------------------------------------------------

Material read_material(const nlohmann::json& material, const std::string& name, const JsonPlace& place);
/// `before` with the given keys changed; with another bsdf everything but the emission starts anew.
Material edited_material(const nlohmann::json& edit, const Material& before, const JsonPlace& place);

/// Adds one object, or one object a material for a model file with its own materials. Model files are looked up beside
/// `folder`, then in GIBENCH_PATH.
void read_object(const nlohmann::json& object, const JsonPlace& place, const std::filesystem::path& folder,
                 SceneBuilder& builder);

/// Whether `name` is an object of the scene, or one that was split by its materials into "name/…".
bool has_object(const Scene& scene, const std::string& name);

Light read_light(const nlohmann::json& light, const JsonPlace& place, const std::filesystem::path& folder, SceneBuilder& builder);
void read_cameras(const nlohmann::json& cameras, const JsonPlace& place, SceneBuilder& builder);

/// Reads edits made one after the other, each on top of those before it. `lights` are the scene file's own.
void read_edits(const nlohmann::json& edits, const nlohmann::json& lights, const JsonPlace& place,
                const std::filesystem::path& folder, SceneBuilder& builder);

Exposure read_exposure(const nlohmann::json& exposure, const JsonPlace& place);

}  // namespace gibench
