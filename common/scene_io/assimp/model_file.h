/// Reading model files (OBJ, PLY, STL, FBX, …) through Assimp; glTF has a reader of its own.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// Reads geometry with quads kept as quads and larger polygons triangulated; points and lines are left out with a
/// warning. Meshes that Assimp hands out with one vertex a corner (OBJ, STL) are joined by equal positions, so duplicate
/// vertices inside them are not distinguished; other meshes keep the vertices of the file. Positions of OBJ and ASCII STL
/// files are read in double precision, others as the single precision that Assimp keeps. Throws InputError at `place`
/// for a file that is not a model, is cut short, has no faces or a face whose index is out of range.
/// `with_materials` false leaves materials at their defaults and reads no pictures.
Model read_with_assimp(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
