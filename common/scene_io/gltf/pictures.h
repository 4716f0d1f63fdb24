/// The pictures of a glTF document, as means over the surfaces that wear them.
#pragma once

#include <list>
#include <string>
#include <utility>
#include <vector>

#include "common/scene_io/gltf/primitive.h"
#include "common/scene_io/pictures/picture_use.h"

namespace gibench {

/// The meaning of a picture's alpha channel.
struct AlphaUse {
  /// As in alphaMode.
  enum class Mode { ignored, weighs, cuts };
  Mode mode = Mode::ignored;
  double threshold = 0.5;  ///< cuts: what is below counts for nothing

  bool operator==(const AlphaUse&) const = default;
};

/// Finds, reads and averages pictures. Those that were read last are kept with their sums, up to a gigabyte.
class GltfPictures {
 public:
  explicit GltfPictures(GltfDocument& document) : document_(document) {}

  /// The mean of the picture that a textureInfo names over the triangles of the primitive, by its texture coordinates,
  /// their transform (KHR_texture_transform) and the sampler; nothing where the picture cannot be read. `remarks` gets
  /// what to tell of it.
  std::optional<PictureMean> mean(const GltfValue& texture_info, const GltfPrimitive& primitive, TexelValues values,
                                  AlphaUse alpha, std::vector<std::string>& remarks);

 private:
  struct Kept {
    std::size_t image;
    TexelValues values;
    AlphaUse alpha;
    TexelSums sums;
  };

  std::optional<std::size_t> image_of(const GltfValue& texture, std::vector<std::string>& remarks) const;
  std::string name_of(std::size_t image) const;
  PictureTexels read(std::size_t image, TexelValues values);
  const Kept* find_kept(std::size_t image, TexelValues values, AlphaUse alpha);
  const TexelSums& sums(std::size_t image, TexelValues values, AlphaUse alpha);

  GltfDocument& document_;
  std::list<Kept> kept_;  ///< the one used last is first
};

}  // namespace gibench
