/// The kind of a model file, by its name.
#pragma once

#include <filesystem>
#include <string>

namespace gibench {

/// Whether Assimp reads files of this name.
bool is_model_name(const std::filesystem::path& file);
bool is_gltf_name(const std::filesystem::path& file);
std::string extension_of(const std::filesystem::path& file);  ///< in lower case, with the dot

}  // namespace gibench
