#include "common/scene_io/assimp/embedded_pictures.h"

#include "common/core/error.h"
#include "common/image/srgb.h"
#include "common/scene_io/assimp/assimp_nodes.h"

namespace gibench {

namespace {

PictureTexels texels_of(const aiTexture& texture) {
  if (texture.mWidth == 0) throw InputError(texture.mFilename.C_Str(), "is a picture without texels");
  PictureTexels picture{static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), {}};
  const std::size_t count = std::size_t{texture.mWidth} * texture.mHeight;
  for (std::size_t i = 0; i < count; ++i) {
    const aiTexel& texel = texture.pcData[i];
    picture.texels.push_back({srgb_to_linear(Rgb(texel.r, texel.g, texel.b) / 255.0F), static_cast<float>(texel.a) / 255.0F});
  }
  return picture;
}

Vec2 texture_point(const aiMesh& mesh, unsigned vertex) {
  const aiVector3D& point = mesh.mTextureCoords[0][vertex];
  return {point.x, point.y};
}

}  // namespace

ModelPictures pictures_of(const aiScene& scene, const std::filesystem::path& folder) {
  return ModelPictures([&scene, folder](const std::string& name) {
    const aiTexture* inside = scene.GetEmbeddedTexture(name.c_str());
    if (inside == nullptr) return read_picture_beside(folder, name);
    if (inside->mHeight > 0) return texels_of(*inside);
    return read_texels(std::string_view(reinterpret_cast<const char*>(inside->pcData), inside->mWidth), name);
  });
}

PictureUse picture_use(const aiScene& scene, unsigned material) {
  PictureUse use;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    if (mesh.mMaterialIndex != material || !mesh.HasTextureCoords(0)) continue;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned i = 2; i < face.mNumIndices; ++i) {
        const unsigned a = face.mIndices[0], b = face.mIndices[i - 1], c = face.mIndices[i];
        use.add({texture_point(mesh, a), texture_point(mesh, b), texture_point(mesh, c)}, to_vec(mesh.mVertices[a]),
                to_vec(mesh.mVertices[b]), to_vec(mesh.mVertices[c]));
      }
    }
  }
  return use;
}

}  // namespace gibench
