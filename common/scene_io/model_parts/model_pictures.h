/// The pictures of a model: gibench has no textures, so a surface gets the mean of what it uses of its picture.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/scene_io/model_parts/material_remarks.h"
#include "common/scene_io/pictures/picture_use.h"

namespace gibench {

/// Where the surfaces of a material lie in their picture.
struct PictureUse {
  std::vector<UvTriangle> triangles;
  std::vector<double> areas;  ///< on the surface, one for each triangle

  void add(const UvTriangle& triangle, const Vec3d& a, const Vec3d& b, const Vec3d& c);
};

/// Takes means. Keeps the picture that was read last and its sums, for materials that share it.
class ModelPictures {
 public:
  using Reader = std::function<PictureTexels(const std::string& name)>;

  /// Pictures in files beside the model.
  explicit ModelPictures(std::filesystem::path folder);
  /// Pictures that the model holds itself, or hands on.
  explicit ModelPictures(Reader reader) : reader_(std::move(reader)) {}

  /// The mean over what is used, of the whole picture where nothing is; remarks say so, and what it closes. Empty, with a
  /// remark, where the picture cannot be read.
  std::optional<Rgb> mean(const std::string& name, const PictureUse& use, PictureWrap wrap, MaterialRemarks& remarks);

 private:
  const TexelSums& sums(const std::string& name);

  Reader reader_;
  std::string last_name_;
  std::optional<TexelSums> last_;
};

/// A picture's texels from a file in `folder`, whose name may be written as on Windows; one that is not there is looked
/// up by its last part, as programs write paths of their own machine. Throws InputError where it cannot be read.
PictureTexels read_picture_beside(const std::filesystem::path& folder, const std::string& name);

}  // namespace gibench
