/// Reading glTF 2.0 files (.gltf, .glb).
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// Whether a file has the name of a glTF file.
bool is_gltf_name(const std::filesystem::path& file);

/// Reads the default scene of the file: triangles, strips and fans of the meshes of all its nodes, with the weights of
/// morph targets applied; materials (material_reader.h); punctual lights; perspective cameras. Photometric units (candela,
/// lux, nit) are taken as radiometric ones (W/sr, W/m², W/(m² sr)) one to one. Whatever is used and not read is named in
/// one warning. Throws InputError at `place` for a file that is damaged, requires an extension that is not supported, or
/// has no faces. `with_materials` false leaves materials at their defaults and reads no pictures.
Model read_gltf(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
