#include "common/image/decoded_image.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/names.h"
#include "common/core/printable_text.h"
#include "common/image/exr_check.h"
#include "common/image/hdr_header.h"
#include "common/image/icc_profile.h"
#include "common/image/picture_format.h"
#include "common/image/png_check.h"
#include "common/image/png_colours.h"
#include "common/image/size_check.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

std::optional<std::size_t> channel_named(const DecodedImage& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  if (found == image.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - image.channels.begin());
}

std::string damage_of(std::string_view bytes, const std::string& format) {
  std::string damage = size_damage(bytes, format);
  if (damage.empty() && format == "png") damage = png_damage(bytes);
  if (damage.empty() && format == "openexr") damage = exr_damage(bytes);
  return damage;
}

/// `keyword`: the profile's name in a PNG. One that calls itself sRGB is followed by taking the samples for sRGB.
void note_profile(const std::string& keyword, DecodedImage& decoded) {
  if (decoded.colour_profile.empty() && keyword.empty()) return;
  const std::string description = description_of_profile(decoded.colour_profile);
  const std::string& name = description.empty() ? keyword : description;
  if (name.find("sRGB") == std::string::npos)
    decoded.colour_remarks.push_back("its embedded colour profile" + (name.empty() ? "" : " " + in_quotes(name)) +
                                     " is not applied");
}

void take_colours(PngColours colours, DecodedImage& decoded) {
  decoded.exponent = colours.exponent, decoded.chromaticities = colours.chromaticities;
  decoded.colour_remarks = std::move(colours.remarks);
  note_profile(colours.profile_name, decoded);
}

void take_header(DecodedImage& decoded, const HdrHeader& header) {
  decoded.chromaticities = header.primaries;
  const auto factor = static_cast<float>(1.0 / header.exposure);
  if (factor == 1.0F) return;
  for (float& sample : decoded.samples) sample *= factor;
}

/// From the file's primaries; empty where they are those of Rec. 709, or the three channels are one grey.
std::optional<ColourConversion> conversion_of(const DecodedImage& decoded, const ColourChannels& channels) {
  const bool has_colours = channels[0] != channels[1];
  if (!has_colours || !decoded.chromaticities || are_rec709(*decoded.chromaticities)) return std::nullopt;
  return ColourConversion::to_rec709(*decoded.chromaticities);
}

}  // namespace

DecodedImage decode_image(const std::filesystem::path& file) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable))
    throw InputError(file.string(), "no such image file", "name an EXR, HDR, PNG or JPEG file that exists");
  return decode_image(read_file(file), file.string());
}

DecodedImage decode_image(std::string_view bytes, const std::string& name) {
  const std::string format = picture_format(bytes, name);
  if (format.empty())
    throw InputError(name, "cannot be read as an image (its first bytes are those of no format that is read)",
                     "give an EXR, HDR, PNG or JPEG file");
  DecodedImage decoded;
  std::string failure = damage_of(bytes, format);
  if (failure.empty() && format == "openexr" && is_luminance_chroma(bytes))
    throw InputError(name, "holds luminance and chroma (channels Y, RY, BY), which are not read", "convert it to R, G, B");
  if (failure.empty()) failure = image_plugin().decode(bytes, format, decoded);
  if (!failure.empty())
    throw InputError(name, "cannot be read as an image (" + printable_text(failure) + ")",
                     "give a whole EXR, HDR, PNG or JPEG file");
  if (format == "hdr") take_header(decoded, read_hdr_header(bytes));
  if (format == "png") take_colours(colours_of_png(bytes), decoded);
  else note_profile("", decoded);
  for (std::vector<std::string>* remarks : {&decoded.remarks, &decoded.colour_remarks})
    for (std::string& remark : *remarks) remark = printable_text(remark);
  if (decoded.chromaticities && !ColourConversion::to_rec709(*decoded.chromaticities))
    throw InputError(name, "the chromaticities of its header span no colours", "correct them");
  return decoded;
}

std::optional<ColourChannels> colour_channels(const DecodedImage& image, const std::string& layer) {
  const std::string prefix = layer.empty() ? "" : layer + ".";
  const auto r = channel_named(image, prefix + "R"), g = channel_named(image, prefix + "G"),
             b = channel_named(image, prefix + "B");
  if (r && g && b) return ColourChannels{*r, *g, *b};
  if (const auto grey = channel_named(image, prefix + "Y")) return ColourChannels{*grey, *grey, *grey};
  return std::nullopt;
}

std::optional<std::size_t> alpha_channel(const DecodedImage& image) { return channel_named(image, "A"); }

Image linear_image(const DecodedImage& decoded, const ColourChannels& channels) {
  // Decoding the same few levels again and again is most of reading a picture: a table for 8 bits, a pow for the rest.
  std::array<float, 256> table;
  const auto linear = [&](float sample) {
    return decoded.exponent ? std::pow(sample, *decoded.exponent) : srgb_to_linear(sample);
  };
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = linear(static_cast<float>(i) / 255.0F);
  const auto value_of = [&](float sample) {
    if (!decoded.integer_samples) return sample;
    const float level = sample * 255.0F;
    const float nearest = std::nearbyint(level);
    return std::abs(level - nearest) < 1e-4F ? table[static_cast<std::size_t>(nearest)] : linear(sample);
  };
  const std::optional<ColourConversion> conversion = conversion_of(decoded, channels);
  Image image{decoded.width, decoded.height, {}};
  const std::size_t stride = decoded.channels.size();
  image.pixels.resize(decoded.samples.size() / stride);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* const pixel = decoded.samples.data() + i * stride;
    image.pixels[i] = {value_of(pixel[channels[0]]), value_of(pixel[channels[1]]), value_of(pixel[channels[2]])};
    if (conversion) image.pixels[i] = (*conversion)(image.pixels[i]);
  }
  return image;
}

}  // namespace gibench
