#include "common/scene_io/pictures/picture_texels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/core/error.h"
#include "common/image/decoded_image.h"

namespace gibench {

namespace {

/// Pictures of floating-point samples hold colours that are multiplied by alpha, those of integers do not.
Texel texel_of(Rgb colour, float alpha, bool multiplied) {
  const float opacity = std::clamp(alpha, 0.0F, 1.0F);
  if (multiplied && opacity > 0.0F) colour /= opacity;
  return {colour, opacity};
}

PictureTexels texels_of(DecodedImage decoded, const std::string& name, TexelValues values) {
  const std::optional<ColourChannels> channels = colour_channels(decoded, "");
  if (!channels)
    throw InputError(name, "has neither R, G, B nor Y channels", "give a picture with colour or grey channels of that name");
  const bool multiplied = !decoded.integer_samples;
  const std::optional<std::size_t> alpha = values == TexelValues::data ? std::nullopt : alpha_channel(decoded);
  if (values == TexelValues::data) decoded.integer_samples = false;  // levels as they stand, without the curve of sRGB
  if (values != TexelValues::colour) decoded.exponent.reset(), decoded.chromaticities.reset(), decoded.colour_remarks.clear();
  const Image image = linear_image(decoded, *channels);
  PictureTexels picture{image.width, image.height, {}, decoded.remarks};
  picture.remarks.insert(picture.remarks.end(), decoded.colour_remarks.begin(), decoded.colour_remarks.end());
  picture.texels.reserve(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float opacity = alpha ? decoded.samples[i * decoded.channels.size() + *alpha] : 1.0F;
    const Texel texel = texel_of(image.pixels[i], opacity, multiplied);
    if (!is_finite(texel.colour) || std::isnan(opacity)) throw InputError(name, "a texel is not finite", "correct the picture");
    picture.texels.push_back(texel);
  }
  return picture;
}

}  // namespace

PictureTexels read_texels(const std::filesystem::path& file, TexelValues values) {
  return texels_of(decode_image(file), file.string(), values);
}

PictureTexels read_texels(std::string_view bytes, const std::string& name, TexelValues values) {
  return texels_of(decode_image(bytes, name), name, values);
}

}  // namespace gibench
