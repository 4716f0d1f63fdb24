/// The image plugin: the only file that sees OpenImageIO. It bundles fmt under the same include guards with
/// exceptions off, so the real one comes first.
#include <fmt/format.h>
// (the order of these two matters)
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <string>

#include "common/image/image_plugin.h"

namespace gibench {

namespace {

/// Larger than any picture meant, smaller than what a broken header would ask for.
constexpr std::int64_t most_samples = std::int64_t{1} << 31;

std::string without_trailing_space(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.empty() ? "unknown reason" : text;
}

/// Runs `work`, which returns a failure or nothing, and turns every exception into a failure.
template <class Work>
std::string guarded(const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return without_trailing_space(error.what());
  } catch (...) {
    return "unknown failure";
  }
}

bool has_integer_samples(const OIIO::ImageSpec& spec) { return !spec.format.is_floating_point(); }

/// Copies the file's data window into its display window, which stays black elsewhere.
void place_data_window(const OIIO::ImageSpec& spec, const std::vector<float>& data, DecodedImage& image) {
  const int channels = spec.nchannels;
  image.samples.assign(
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * static_cast<std::size_t>(channels), 0.0F);
  const int left = std::max(spec.x, spec.full_x), right = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
  const int top = std::max(spec.y, spec.full_y), bottom = std::min(spec.y + spec.height, spec.full_y + spec.full_height);
  for (int y = top; y < bottom && left < right; ++y) {
    const std::ptrdiff_t from = (std::ptrdiff_t{y - spec.y} * spec.width + (left - spec.x)) * channels;
    const std::ptrdiff_t to = (std::ptrdiff_t{y - spec.full_y} * spec.full_width + (left - spec.full_x)) * channels;
    std::copy_n(data.begin() + from, std::ptrdiff_t{right - left} * channels, image.samples.begin() + to);
  }
}

std::string decode_bytes(std::string_view bytes, const std::string& format, DecodedImage& image) {
  OIIO::ImageSpec wishes, spec;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::Filesystem::IOMemReader source(bytes.data(), bytes.size());
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input) return without_trailing_space(OIIO::geterror());
  if (!input->set_ioproxy(&source)) return format + " cannot be read from memory";
  if (!input->open("memory." + format, spec, wishes)) return without_trailing_space(input->geterror());
  const bool windows_agree =
      spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width && spec.height == spec.full_height;
  if (spec.width <= 0 || spec.height <= 0 || spec.full_width <= 0 || spec.full_height <= 0 || spec.nchannels <= 0)
    return "no pixels";
  const auto samples = [&](int width, int height) { return std::int64_t{width} * height > most_samples / spec.nchannels; };
  if (samples(spec.width, spec.height) || samples(spec.full_width, spec.full_height)) return "more pixels than a picture has";
  std::vector<float> data(static_cast<std::size_t>(spec.image_pixels()) * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, data.data()))
    return without_trailing_space(input->geterror());
  image.width = spec.full_width;
  image.height = spec.full_height;
  image.channels = spec.channelnames;
  image.integer_samples = has_integer_samples(spec);
  for (const OIIO::ParamValue& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeString) image.header[attribute.name().string()] = attribute.get_string();
  if (windows_agree) image.samples = std::move(data);
  else place_data_window(spec, data, image);
  return {};
}

/// Encodes to memory: the file itself is written by one routine that knows of full disks and renames.
template <class Samples>
std::string encode(const char* format, const OIIO::ImageSpec& spec, const Samples& samples, std::vector<char>& bytes) {
  OIIO::ImageSpec with_target = spec;
  std::vector<unsigned char> buffer;
  OIIO::Filesystem::IOVecOutput target(buffer);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output) return without_trailing_space(OIIO::geterror());
  if (!output->set_ioproxy(&target)) return std::string(format) + " cannot be written to memory";
  const std::string name = std::string("memory.") + format;
  const bool done = output->open(name, with_target) && output->write_image(spec.format, samples.data()) && output->close();
  if (!done) return without_trailing_space(output->geterror());
  bytes.assign(buffer.begin(), buffer.end());
  return {};
}

std::string encode_float_exr(int width, int height, std::span<const EncodedChannel> channels,
                             std::span<const std::pair<std::string, std::string>> header, std::vector<char>& bytes) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const EncodedChannel& channel : channels) spec.channelnames.push_back(channel.name);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "0000:00:00 00:00:00");  // the time of writing would make equal pictures differ in their bytes
  for (const auto& [name, value] : header) spec.attribute(name, value);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<float> samples(pixels * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (std::size_t i = 0; i < pixels; ++i) samples[i * channels.size() + c] = channels[c].first[i * channels[c].stride];
  return encode("exr", spec, samples, bytes);
}

std::string encode_srgb_png(int width, int height, std::span<const std::uint8_t> rgb, std::vector<char>& bytes) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encode("png", spec, rgb, bytes);
}

constexpr ImagePluginFunctions functions{
    [](std::string_view bytes, const std::string& format, DecodedImage& image) {
      return guarded([&] { return decode_bytes(bytes, format, image); });
    },
    [](int width, int height, std::span<const EncodedChannel> channels,
       std::span<const std::pair<std::string, std::string>> header,
       std::vector<char>& bytes) { return guarded([&] { return encode_float_exr(width, height, channels, header, bytes); }); },
    [](int width, int height, std::span<const std::uint8_t> rgb, std::vector<char>& bytes) {
      return guarded([&] { return encode_srgb_png(width, height, rgb, bytes); });
    }};

}  // namespace

}  // namespace gibench

extern "C" const gibench::ImagePluginFunctions* gibench_image_plugin() {
  // One thread: the program's own loops use the cores, and a child process starts sooner.
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", 1);
  return &gibench::functions;
}
