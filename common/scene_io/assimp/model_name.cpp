#include "common/scene_io/assimp/model_name.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>

namespace gibench {

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_model_name(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  return !extension.empty() && extension != ".json" && Assimp::Importer().IsExtensionSupported(extension);
}

}  // namespace gibench
