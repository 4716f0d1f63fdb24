#include "common/scene_io/assimp/picture_mean.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "common/core/error.h"
#include "common/image/image_file.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

Rgb mean_of(const Image& image) {
  RgbDouble sum;
  for (const Rgb& pixel : image.pixels) sum += RgbDouble(pixel);
  return Rgb(sum / static_cast<double>(std::max<std::size_t>(1, image.pixels.size())));
}

Rgb mean_of_texels(const aiTexture& texture) {
  const std::size_t count = std::size_t{texture.mWidth} * texture.mHeight;
  RgbDouble sum;
  for (std::size_t i = 0; i < count; ++i) {
    const aiTexel& texel = texture.pcData[i];
    sum += RgbDouble(srgb_to_linear(Rgb(texel.r, texel.g, texel.b) / 255.0F));
  }
  return Rgb(sum / static_cast<double>(std::max<std::size_t>(1, count)));
}

/// A picture file inside the model: read_image() wants a file, so it gets one for as long as it reads.
class TemporaryPicture {
 public:
  explicit TemporaryPicture(const aiTexture& texture)
      : file_(fs::temp_directory_path() / ("gibench-picture-" + std::to_string(getpid()) + "." + texture.achFormatHint)) {
    std::ofstream(file_, std::ios::binary).write(reinterpret_cast<const char*>(texture.pcData), texture.mWidth);
  }
  ~TemporaryPicture() {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
  TemporaryPicture(const TemporaryPicture&) = delete;
  TemporaryPicture& operator=(const TemporaryPicture&) = delete;

  const fs::path& file() const { return file_; }

 private:
  fs::path file_;
};

}  // namespace

Rgb PictureMeans::mean(const std::string& name) {
  const auto found = known_.find(name);
  return found != known_.end() ? found->second : known_.emplace(name, read(name)).first->second;
}

Rgb PictureMeans::read(const std::string& name) const {
  if (const aiTexture* inside = scene_.GetEmbeddedTexture(name.c_str()))
    return inside->mHeight > 0 ? mean_of_texels(*inside) : mean_of(read_image(TemporaryPicture(*inside).file()));
  std::string relative = name;
  std::replace(relative.begin(), relative.end(), '\\', '/');  // as written on Windows
  const fs::path file = folder_ / relative;
  if (!fs::exists(file)) throw InputError(file.string(), "does not exist");
  return mean_of(read_image(file));
}

}  // namespace gibench
