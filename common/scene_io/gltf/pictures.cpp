#include "common/scene_io/gltf/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/gltf/uri.h"

namespace gibench {

namespace {

constexpr std::size_t most_kept_texels = std::size_t{1} << 26U;  // 1 GB: four pictures of 4096 x 4096

Wrap wrap_of(const std::optional<GltfValue>& sampler, const char* key) {
  constexpr std::size_t clamp = 33071, mirror = 33648;
  const std::size_t code = sampler ? sampler->whole_number_or(key, 0) : 0;
  return code == clamp ? Wrap::clamp : code == mirror ? Wrap::mirror : Wrap::repeat;
}

/// u' = T R S u of KHR_texture_transform, whose rotation turns coordinates counter-clockwise as seen with v downwards.
struct CoordinateTransform {
  std::array<double, 2> offset{0.0, 0.0}, scale{1.0, 1.0};
  double cosine = 1.0, sine = 0.0;

  Vec2 apply(const double* uv) const {
    const double u = scale[0] * uv[0], v = scale[1] * uv[1];
    // UvTriangle counts v upwards.
    return {static_cast<float>(cosine * u + sine * v + offset[0]), static_cast<float>(1.0 - (cosine * v - sine * u + offset[1]))};
  }
};

CoordinateTransform transform_of(const std::optional<GltfValue>& extension) {
  CoordinateTransform transform;
  if (!extension) return transform;
  transform.offset = extension->numbers_or<2>("offset", transform.offset);
  transform.scale = extension->numbers_or<2>("scale", transform.scale);
  const double angle = extension->number_or("rotation", 0.0);
  transform.cosine = std::cos(angle), transform.sine = std::sin(angle);
  return transform;
}

void apply_alpha(AlphaUse alpha, PictureTexels& picture) {
  switch (alpha.mode) {
    case AlphaUse::Mode::weighs: return;
    case AlphaUse::Mode::ignored:
      for (Texel& texel : picture.texels) texel.opacity = 1.0F;
      return;
    case AlphaUse::Mode::cuts:
      for (Texel& texel : picture.texels) texel.opacity = static_cast<double>(texel.opacity) >= alpha.threshold ? 1.0F : 0.0F;
      return;
  }
}

}  // namespace

std::optional<std::size_t> GltfPictures::image_of(const GltfValue& texture, std::vector<std::string>& remarks) const {
  if (const auto source = texture.whole_number_if("source")) return source;
  if (const auto webp = texture.extension("EXT_texture_webp")) return webp->at("source").whole_number();
  remarks.push_back("a picture is not used (" + texture.path() + " names none outside extensions that are not supported)");
  return std::nullopt;
}

std::string GltfPictures::name_of(std::size_t image) const {
  const GltfValue value = document_.item("images", image);
  if (const auto uri = value.find("uri"); uri && !is_data_uri(uri->text())) return percent_decoded(uri->text());
  const std::string name = value.text_or("name", value.path()), type = value.text_or("mimeType", "");
  return type == "image/png"    ? name + ".png"
         : type == "image/jpeg" ? name + ".jpg"
         : type == "image/webp" ? name + ".webp"
                                : name;
}

PictureTexels GltfPictures::read(std::size_t image, TexelValues values) {
  const GltfValue value = document_.item("images", image);
  const auto uri = value.find("uri");
  if (!uri) return read_texels(document_.view_bytes(value.at("bufferView").whole_number()), name_of(image), values);
  const std::string text = uri->text();
  if (is_remote_uri(text)) uri->refuse("is " + in_quotes(text) + ", and only local files are read");
  if (!is_data_uri(text)) return read_texels(document_.path_of_uri(text), values);
  const auto data = data_of_uri(text);
  if (!data) uri->refuse("is a data: URI that is not base64");
  return read_texels(*data, name_of(image), values);
}

/// Null where there is none; else it is the one used last from now on.
const GltfPictures::Kept* GltfPictures::find_kept(std::size_t image, TexelValues values, AlphaUse alpha) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return kept.image == image && kept.values == values && kept.alpha == alpha;
  });
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return &kept_.front();
}

const TexelSums& GltfPictures::sums(std::size_t image, TexelValues values, AlphaUse alpha) {
  if (const Kept* kept = find_kept(image, values, alpha)) return kept->sums;
  const Kept* as_read = find_kept(image, values, {AlphaUse::Mode::weighs});
  PictureTexels texels = as_read != nullptr ? as_read->sums.picture() : read(image, values);
  apply_alpha(alpha, texels);
  kept_.push_front({image, values, alpha, TexelSums(std::move(texels))});
  std::size_t sum = 0;
  for (auto entry = kept_.begin(); entry != kept_.end(); ++entry) {
    sum += entry->sums.picture().texels.size();
    if (sum <= most_kept_texels || entry == kept_.begin()) continue;
    kept_.erase(entry, kept_.end());
    break;
  }
  return kept_.front().sums;
}

std::optional<PictureMean> GltfPictures::mean(const GltfValue& texture_info, const GltfPrimitive& primitive, TexelValues values,
                                              AlphaUse alpha, std::vector<std::string>& remarks) {
  const GltfValue texture = document_.item("textures", texture_info.at("index").whole_number());
  const auto image = image_of(texture, remarks);
  if (!image) return std::nullopt;
  const auto extension = texture_info.extension("KHR_texture_transform");
  const std::size_t set = extension && extension->has("texCoord") ? extension->at("texCoord").whole_number()
                                                                  : texture_info.whole_number_or("texCoord", 0);
  const auto coordinates = primitive.attribute(document_, ("TEXCOORD_" + std::to_string(set)).c_str());
  std::optional<GltfValue> sampler;
  if (const auto index = texture.whole_number_if("sampler")) sampler = document_.item("samplers", *index);
  try {
    const TexelSums& picture = sums(*image, values, alpha);
    remarks.push_back("the picture " + in_quotes(name_of(*image)) + " is replaced by its mean" +
                      (coordinates ? "" : " (over all of it: a mesh has no TEXCOORD_" + std::to_string(set) + ")"));
    for (const std::string& remark : picture.picture().remarks)
      remarks.push_back("the picture " + in_quotes(name_of(*image)) + ": " + remark);
    if (!coordinates || coordinates->components != 2) return mean_of_picture(picture);
    const CoordinateTransform transform = transform_of(extension);
    std::vector<UvTriangle> triangles;
    triangles.reserve(primitive.triangles.size());
    for (const auto& [a, b, c] : primitive.triangles)
      triangles.push_back(
          {transform.apply(coordinates->row(a)), transform.apply(coordinates->row(b)), transform.apply(coordinates->row(c))});
    return mean_over_triangles(picture, triangles, primitive.areas(), {wrap_of(sampler, "wrapS"), wrap_of(sampler, "wrapT")});
  } catch (const InputError& error) {
    remarks.push_back("a picture is not used (" + std::string(error.what()) + ")");
    return std::nullopt;
  }
}

}  // namespace gibench
