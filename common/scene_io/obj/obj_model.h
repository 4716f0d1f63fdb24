/// Reading OBJ files and their MTL files.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// One part for each object or group and material, in double precision; vertices at one place are one. Throws InputError
/// at `place`. `with_materials` false leaves materials at their defaults and reads no other file.
Model read_obj(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
