#include "common/image/exr_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "common/image/byte_reader.h"

namespace gibench {

namespace {

constexpr std::size_t bytes_before_headers = 8;
constexpr std::uint32_t several_parts = 0x1000;  // flag of the version field

/// Inclusive corners.
struct Window {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;

  std::int64_t width() const { return right - left + 1; }
  std::int64_t height() const { return bottom - top + 1; }
};

struct Channel {
  std::string_view name;
  std::int64_t bytes = 4, x_sampling = 1, y_sampling = 1;
};

struct Part {
  std::vector<Channel> channels;
  Window data;
  std::uint32_t compression = 0;
  std::int64_t tile_width = 0, tile_height = 0;  // 0: scanlines
  std::int64_t chunks = 0;                       // as stated; 0: not stated
};

Window window_of(std::string_view value) {
  ByteReader reader(value);
  Window window;
  window.left = reader.integer(), window.top = reader.integer();
  window.right = reader.integer(), window.bottom = reader.integer();
  return window;
}

std::vector<Channel> channels_of(std::string_view value) {
  ByteReader reader(value);
  std::vector<Channel> channels;
  while (!reader.has_failed() && reader.left() > 1) {
    Channel channel;
    channel.name = reader.text();
    channel.bytes = reader.number() == 1 ? 2 : 4;  // half; unsigned, float
    reader.take(4);
    channel.x_sampling = reader.integer(), channel.y_sampling = reader.integer();
    channels.push_back(channel);
  }
  return channels;
}

void take_attribute(Part& part, std::string_view name, std::string_view value) {
  ByteReader reader(value);
  if (name == "channels") part.channels = channels_of(value);
  else if (name == "dataWindow") part.data = window_of(value);
  else if (name == "compression") part.compression = reader.byte();
  else if (name == "chunkCount") part.chunks = reader.integer();
  else if (name == "tiles") part.tile_width = reader.number(), part.tile_height = reader.number();
}

/// Most rows of a chunk of scanlines, by kind of compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
std::int64_t rows_of_chunk(std::uint32_t compression) {
  constexpr std::array<std::int64_t, 10> rows{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  return rows[std::min<std::size_t>(compression, rows.size() - 1)];
}

/// Most bytes of samples that a byte of the file stands for: deflate makes 1032 of one at best, PXR24 keeps three of a float's
/// four bytes, and the two kinds of DWA keep one of the 64 coefficients of a flat block.
std::int64_t most_bytes_for_one(std::uint32_t compression) {
  constexpr std::uint32_t pxr24 = 5, first_dwa = 8;
  if (compression >= first_dwa) return 64 * 1032;
  return compression == pxr24 ? 1032 * 4 / 3 : 1032;
}

std::int64_t divided_up(std::int64_t number, std::int64_t by) { return (number + by - 1) / std::max<std::int64_t>(1, by); }

std::int64_t chunks_of(const Part& part) {
  if (part.tile_width > 0 && part.tile_height > 0)
    return divided_up(part.data.width(), part.tile_width) * divided_up(part.data.height(), part.tile_height);
  return divided_up(part.data.height(), rows_of_chunk(part.compression));
}

/// In double: a product of three stated numbers may be more than an integer holds.
double bytes_of_samples(const Part& part) {
  double bytes = 0.0;
  for (const Channel& channel : part.channels)
    bytes += static_cast<double>(channel.bytes) * static_cast<double>(divided_up(part.data.width(), channel.x_sampling)) *
             static_cast<double>(divided_up(part.data.height(), channel.y_sampling));
  return bytes;
}

std::string damage_of(const Part& part, std::size_t length) {
  if (part.data.width() <= 0 || part.data.height() <= 0) return "its data window has no pixels";
  const auto most_chunks = static_cast<std::int64_t>(length / 8);  // each has its place in a table
  const bool fits =
      part.chunks <= most_chunks && chunks_of(part) <= most_chunks &&
      bytes_of_samples(part) <= static_cast<double>(most_bytes_for_one(part.compression)) * static_cast<double>(length);
  return fits ? "" : "its header states more pixels than a file of its length can hold";
}

struct Headers {
  std::vector<Part> parts;
  std::string damage;
};

/// One header, up to its end mark.
std::string read_header(ByteReader& reader, Part& part) {
  while (!reader.is_next('\0')) {
    const std::string_view name = reader.text();
    reader.text();  // type
    const int size = reader.integer();
    if (reader.has_failed()) return "the file is truncated";
    if (size < 0 || static_cast<std::size_t>(size) > reader.left()) return "an attribute of its header is longer than the file";
    take_attribute(part, name, reader.take(static_cast<std::size_t>(size)));
  }
  reader.take(1);
  return {};
}

Headers read_headers(std::string_view bytes) {
  Headers headers;
  ByteReader reader(bytes);
  reader.take(bytes_before_headers - 4);
  const bool has_several = (reader.number() & several_parts) != 0;
  do {
    Part part;
    headers.damage = read_header(reader, part);
    if (headers.damage.empty()) headers.damage = damage_of(part, bytes.size());
    headers.parts.push_back(std::move(part));
  } while (headers.damage.empty() && has_several && reader.left() > 0 && !reader.is_next('\0'));
  return headers;
}

bool has_channel(const Part& part, std::string_view name) {
  return std::ranges::any_of(part.channels, [&](const Channel& channel) { return channel.name == name; });
}

}  // namespace

std::string exr_damage(std::string_view bytes) { return read_headers(bytes).damage; }

bool is_luminance_chroma(std::string_view bytes) {
  const std::vector<Part> parts = read_headers(bytes).parts;
  const auto has_colours = [](const Part& part) {
    return has_channel(part, "R") && has_channel(part, "G") && has_channel(part, "B");
  };
  const auto has_chroma = [](const Part& part) { return has_channel(part, "RY") || has_channel(part, "BY"); };
  return std::ranges::any_of(parts, has_chroma) && std::ranges::none_of(parts, has_colours);
}

}  // namespace gibench
