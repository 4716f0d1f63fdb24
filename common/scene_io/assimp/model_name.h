/// The kind of a model file, by its name.
#pragma once

#include <filesystem>
#include <string>

namespace gibench {

/// Whether files of this name can be read: by Assimp, or as glTF, whose names Assimp knows too.
bool is_model_name(const std::filesystem::path& file);
std::string extension_of(const std::filesystem::path& file);  ///< in lower case, with the dot

}  // namespace gibench
