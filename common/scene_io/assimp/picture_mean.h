/// The mean colour of a model's pictures: gibench has no textures, so a textured surface gets their mean.
#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <map>
#include <string>

#include "common/core/rgb.h"

namespace gibench {

/// Reads every picture once.
class PictureMeans {
 public:
  PictureMeans(const aiScene& scene, std::filesystem::path folder) : scene_(scene), folder_(std::move(folder)) {}

  /// Mean of the linear pixels of a picture, in a file beside the model or inside the model. Throws InputError
  /// where it cannot be read.
  Rgb mean(const std::string& name);

 private:
  Rgb read(const std::string& name) const;

  const aiScene& scene_;
  std::filesystem::path folder_;
  std::map<std::string, Rgb> known_;
};

}  // namespace gibench
