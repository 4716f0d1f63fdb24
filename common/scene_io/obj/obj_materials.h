/// The materials of an OBJ file's faces.
#pragma once

#include <filesystem>

#include "common/scene_io/model.h"
#include "common/scene_io/obj/obj_text.h"

namespace gibench {

/// Sets `materials` of the model and `material` of its parts, which are those of `obj` in the same order: the materials of
/// the MTL files that are used, in their order, and default ones for names that are defined nowhere and for faces without
/// a name; where vertices have colours, each such part has one of its own, of their mean. Warns of files and names that are not
/// there.
void read_obj_materials(const ObjText& obj, const std::filesystem::path& file, const ModelPlace& place, Model& model);

}  // namespace gibench
