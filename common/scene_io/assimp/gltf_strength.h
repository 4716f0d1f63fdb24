/// The strength of emitters in glTF files, which Assimp 5.2 leaves out.
#pragma once

#include <filesystem>
#include <vector>

namespace gibench {

/// emissiveStrength of every material (KHR_materials_emissive_strength), 1 where there is none; empty for a file
/// that is not glTF. glTF material i is Assimp's material i.
std::vector<float> gltf_emissive_strengths(const std::filesystem::path& file);

}  // namespace gibench
