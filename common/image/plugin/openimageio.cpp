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
#include "common/image/plugin/png_decoding.h"

namespace gibench {

namespace {

/// Larger than any picture meant (16384 × 8192 of four channels), smaller than what a broken header would ask for.
constexpr std::int64_t most_samples = std::int64_t{1} << 29;
/// Formats that are not checked before have none that makes more samples of one byte; small pictures are not asked.
constexpr std::int64_t most_samples_a_byte = 16384, samples_not_asked_about = std::int64_t{1} << 24;

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
  const std::ptrdiff_t channels = spec.nchannels;
  image.samples.assign(
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * static_cast<std::size_t>(channels), 0.0F);
  const auto end_of = [](int begin, int size) { return std::int64_t{begin} + size; };
  const std::int64_t left = std::max(spec.x, spec.full_x), top = std::max(spec.y, spec.full_y);
  const std::int64_t right = std::min(end_of(spec.x, spec.width), end_of(spec.full_x, spec.full_width));
  const std::int64_t bottom = std::min(end_of(spec.y, spec.height), end_of(spec.full_y, spec.full_height));
  for (std::int64_t y = top; y < bottom && left < right; ++y) {
    const std::ptrdiff_t from = ((y - spec.y) * spec.width + (left - spec.x)) * channels;
    const std::ptrdiff_t to = ((y - spec.full_y) * spec.full_width + (left - spec.full_x)) * channels;
    std::copy_n(data.begin() + from, (right - left) * channels, image.samples.begin() + to);
  }
}

bool has_channel(const OIIO::ImageSpec& spec, const char* name) {
  return std::ranges::find(spec.channelnames, name) != spec.channelnames.end();
}

/// How well a part serves as a picture: with colours, grey, with neither, not at all.
int worth_of(const OIIO::ImageSpec& spec) {
  if (spec.deep) return 0;
  if (has_channel(spec, "R") && has_channel(spec, "G") && has_channel(spec, "B")) return 3;
  return has_channel(spec, "Y") ? 2 : 1;
}

std::string name_of_part(const OIIO::ImageSpec& spec, int part) {
  const std::string name = spec.get_string_attribute("oiio:subimagename");
  return name.empty() ? std::to_string(part + 1) : "\"" + name + "\"";
}

/// The first of the parts that serve best; a remark names the others.
int best_part(OIIO::ImageInput& input, std::vector<std::string>& remarks) {
  std::vector<std::string> names;
  int best = 0, worth = -1;
  for (int part = 0; input.seek_subimage(part, 0); ++part) {
    const OIIO::ImageSpec spec = input.spec();
    names.push_back(name_of_part(spec, part));
    if (worth_of(spec) > worth) best = part, worth = worth_of(spec);
  }
  input.geterror();  // that there are no more parts
  if (names.size() < 2) return best;
  std::string others;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (static_cast<int>(i) != best) others += (others.empty() ? "" : ", ") + names[i];
  remarks.push_back("of its parts only " + names[static_cast<std::size_t>(best)] + " is read, not " + others);
  return best;
}

/// OpenEXR's parts are pictures of one view; what other formats hold besides the first is another page or the next frame.
int chosen_part(OIIO::ImageInput& input, const std::string& format, std::vector<std::string>& remarks) {
  if (format == "openexr") return best_part(input, remarks);
  if ((format == "tiff" || format == "gif") && input.seek_subimage(1, 0))
    remarks.push_back("only the first of its pictures is read");
  input.geterror();  // that there is only one
  return 0;
}

std::string size_fault(const OIIO::ImageSpec& spec, std::size_t bytes) {
  if (spec.width <= 0 || spec.height <= 0 || spec.full_width <= 0 || spec.full_height <= 0 || spec.nchannels <= 0)
    return "no pixels";
  const auto too_many = [&](int width, int height) { return std::int64_t{width} * height > most_samples / spec.nchannels; };
  if (too_many(spec.width, spec.height) || too_many(spec.full_width, spec.full_height)) return "more pixels than a picture has";
  const std::int64_t samples = std::int64_t{spec.width} * spec.height * spec.nchannels;
  if (samples > samples_not_asked_about && samples / most_samples_a_byte > static_cast<std::int64_t>(bytes))
    return "its header states more pixels than a file of its length can hold";
  return {};
}

void take_header(const OIIO::ImageSpec& spec, DecodedImage& image) {
  image.width = spec.full_width;
  image.height = spec.full_height;
  image.channels = spec.channelnames;
  image.integer_samples = has_integer_samples(spec);
  for (const OIIO::ParamValue& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeString) image.header[attribute.name().string()] = attribute.get_string();
  Chromaticities chromaticities{};
  const OIIO::TypeDesc eight_floats(OIIO::TypeDesc::FLOAT, static_cast<int>(chromaticities.size()));
  if (spec.getattribute("chromaticities", eight_floats, chromaticities.data())) image.chromaticities = chromaticities;
  if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile"))
    image.colour_profile.assign(static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->datasize()));
}

std::string decode_bytes(std::string_view bytes, const std::string& format, DecodedImage& image) {
  if (format == "png") return decode_png(bytes, most_samples, image);
  OIIO::ImageSpec wishes, spec;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::Filesystem::IOMemReader source(bytes.data(), bytes.size());
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input) return without_trailing_space(OIIO::geterror());
  if (!input->set_ioproxy(&source)) return format + " cannot be read from memory";
  if (!input->open("memory." + format, spec, wishes)) return without_trailing_space(input->geterror());
  const int part = chosen_part(*input, format, image.remarks);
  if (!input->seek_subimage(part, 0)) return without_trailing_space(input->geterror());
  spec = input->spec();
  if (spec.deep) return "its samples are deep, which are not read";
  if (std::string fault = size_fault(spec, bytes.size()); !fault.empty()) return fault;
  std::vector<float> data(static_cast<std::size_t>(spec.image_pixels()) * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(part, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, data.data()))
    return without_trailing_space(input->geterror());
  take_header(spec, image);
  const bool windows_agree =
      spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width && spec.height == spec.full_height;
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
