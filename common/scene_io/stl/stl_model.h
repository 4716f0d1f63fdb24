/// Reading STL files.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// Binary STL, where the length is that of its facets, or text in any spelling: one part for each solid, in double
/// precision; vertices at one place are one. STL has no materials. Warns of what is left out; throws InputError at `place`.
Model read_stl(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
