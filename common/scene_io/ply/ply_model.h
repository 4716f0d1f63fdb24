/// Reading PLY files.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// One part: the vertices of the file in double precision, its faces and strips of triangles. The mean colour of the
/// vertices, taken as linear, is the albedo. Warns of what is left out; throws InputError at `place`. `with_materials` false
/// leaves the material at its defaults.
Model read_ply(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
