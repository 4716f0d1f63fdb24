/// Reading model files (FBX, COLLADA, …) through Assimp.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// Reads geometry with quads kept as quads and larger polygons triangulated; points and lines are left out with a
/// warning. Meshes that Assimp hands out with one vertex a corner are joined by equal positions, so duplicate vertices
/// inside them are not distinguished; other meshes keep the vertices of the file. Positions have the single precision that
/// Assimp keeps. Lengths are metres: those of FBX and COLLADA files are converted by the unit that they state. Throws InputError
/// at `place` for a file that is not a model, cannot be read, has no faces or a face whose index is out of range.
/// `with_materials` false leaves materials at their defaults and reads no pictures.
Model read_with_assimp(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
