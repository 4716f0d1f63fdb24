#include "common/reference/packed_replicas.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "common/core/error.h"
#include "common/core/random.h"

namespace gibench {

namespace {

constexpr std::uint64_t dither_stage = 0x646974686572ULL;
constexpr std::int8_t all_zero = std::numeric_limits<std::int8_t>::min();  // in place of an exponent
constexpr int half_bits = 11;                                              // of a 16-bit float's mantissa
constexpr int middle = 8, reach = 7;                                       // deviations are in four bits: -7 to 7
constexpr std::size_t base_bytes = 4;

double channel_of(const Replicas& replicas, std::size_t replica, std::size_t index) {
  const Rgb& value = replicas.replicas[replica][index / 3];
  return index % 3 == 0 ? value.r : index % 3 == 1 ? value.g : value.b;
}

float& channel_of(Replicas& replicas, std::size_t replica, std::size_t index) {
  Rgb& value = replicas.replicas[replica][index / 3];
  return index % 3 == 0 ? value.r : index % 3 == 1 ? value.g : value.b;
}

double size_of(Grain grain) { return 0.5 * static_cast<char>(grain); }

double dither(std::size_t replica, std::size_t index) { return RandomStream(replica, dither_stage, index).next_double() - 0.5; }

/// The sections of the bytes, one after the other, before they are deflated: the grain, an exponent of each number's step, the
/// four bytes of its base (the lowest of all first, then the next: equal bytes stand together), then its deviations, two to a
/// byte.
struct Layout {
  std::size_t count, numbers;  // replicates, channels of values

  static std::size_t exponents() { return 1; }
  std::size_t bases() const { return exponents() + numbers; }
  std::size_t deviations() const { return bases() + base_bytes * numbers; }
  std::size_t bytes() const { return deviations() + (count * numbers + 1) / 2; }
};

struct Moments {
  double mean = 0.0, deviation = 0.0, largest = 0.0;  // largest: of the absolute values
};

Moments moments_of(const Replicas& replicas, std::size_t index) {
  Moments m;
  const auto count = static_cast<double>(replicas.count());
  for (std::size_t r = 0; r < replicas.count(); ++r) {
    m.mean += channel_of(replicas, r, index) / count;
    m.largest = std::max(m.largest, std::abs(channel_of(replicas, r, index)));
  }
  double squares = 0.0;
  for (std::size_t r = 0; r < replicas.count(); ++r) squares += std::pow(channel_of(replicas, r, index) - m.mean, 2.0);
  m.deviation = count > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  return m;
}

/// The step is g 2^exponent. With Δ > σ no replicate is further than (R − 1)/√R steps from the mean: 3.75 of 16, and with the
/// roundings of base and replicate five in all, so that every deviation fits into four bits.
int exponent_of(const Moments& m) {
  const double least = std::max({m.deviation, std::abs(m.mean) * std::ldexp(1.0, -half_bits), 1e-37});
  return static_cast<int>(std::floor(std::log2(least))) + 1;
}

std::string deflated(const std::string& plain) {
  z_stream stream{};
  GIBENCH_CHECK(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS, 9, Z_FILTERED) == Z_OK, "zlib starts");
  std::string bytes(deflateBound(&stream, static_cast<uLong>(plain.size())), '\0');
  std::string input = plain;  // zlib does not change it, but wants to be allowed to
  stream.next_in = reinterpret_cast<Bytef*>(input.data()), stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data()), stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  GIBENCH_CHECK(status == Z_STREAM_END, "the bound of zlib bounds");
  return bytes;
}

/// Empty where it is not `size` bytes.
std::string inflated(std::string_view bytes, std::size_t size) {
  std::string plain(size, '\0');
  auto length = static_cast<uLongf>(size);
  const int status = uncompress(reinterpret_cast<Bytef*>(plain.data()), &length, reinterpret_cast<const Bytef*>(bytes.data()),
                                static_cast<uLong>(bytes.size()));
  return status == Z_OK && length == size ? plain : std::string();
}

void pack_number(const Replicas& replicas, std::size_t index, const Layout& layout, Grain grain, std::string& plain) {
  const Moments m = moments_of(replicas, index);
  char& kept_exponent = plain[Layout::exponents() + index];
  if (m.largest == 0.0) {
    kept_exponent = static_cast<char>(all_zero);
    return;
  }
  const int exponent = exponent_of(m);
  const double step = std::ldexp(size_of(grain), exponent);
  const auto base = static_cast<std::int32_t>(std::lround(m.mean / step));
  kept_exponent = static_cast<char>(exponent);
  for (std::size_t byte = 0; byte < base_bytes; ++byte)
    plain[layout.bases() + byte * layout.numbers + index] = static_cast<char>(static_cast<std::uint32_t>(base) >> (8 * byte));
  for (std::size_t r = 0; r < layout.count; ++r) {
    const double steps = std::floor(channel_of(replicas, r, index) / step + dither(r, index) + 0.5);
    const int deviation = static_cast<int>(steps) - base;
    GIBENCH_CHECK(std::abs(deviation) <= reach, "a replicate lies within (R - 1)/sqrt(R) standard deviations");
    const std::size_t place = r * layout.numbers + index;
    char& pair = plain[layout.deviations() + place / 2];
    pair = static_cast<char>(pair | (deviation + middle) << (place % 2 == 0 ? 0 : 4));
  }
}

void unpack_number(const std::string& plain, std::size_t index, const Layout& layout, Replicas& replicas) {
  const auto exponent = static_cast<std::int8_t>(plain[Layout::exponents() + index]);
  if (exponent == all_zero) return;
  const double step = std::ldexp(size_of(Grain{plain[0]}), exponent);
  std::uint32_t bits = 0;
  for (std::size_t byte = 0; byte < base_bytes; ++byte)
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(plain[layout.bases() + byte * layout.numbers + index]))
            << (8 * byte);
  const auto base = static_cast<std::int32_t>(bits);
  for (std::size_t r = 0; r < layout.count; ++r) {
    const std::size_t place = r * layout.numbers + index;
    const auto pair = static_cast<unsigned char>(plain[layout.deviations() + place / 2]);
    const int deviation = static_cast<int>((place % 2 == 0 ? pair : pair >> 4U) & 15U) - middle;
    channel_of(replicas, r, index) = static_cast<float>((base + deviation - dither(r, index)) * step);
  }
}

}  // namespace

std::string pack_replicas(const Replicas& replicas, Grain grain) {
  GIBENCH_CHECK(replicas.count() <= most_packed_replicas, "deviations fit into four bits");
  const Layout layout{replicas.count(), 3 * replicas.size()};
  std::string plain(layout.bytes(), '\0');
  plain[0] = static_cast<char>(grain);
  for (std::size_t index = 0; index < layout.numbers; ++index) pack_number(replicas, index, layout, grain, plain);
  return deflated(plain);
}

Replicas unpack_replicas(std::string_view bytes, std::size_t count, std::size_t size) {
  const Layout layout{count, 3 * size};
  const std::string plain = inflated(bytes, layout.bytes());
  Replicas replicas;
  if (plain.size() != layout.bytes()) return replicas;
  replicas.replicas.assign(count, std::vector<Rgb>(size));
  for (std::size_t index = 0; index < layout.numbers; ++index) unpack_number(plain, index, layout, replicas);
  return replicas;
}

}  // namespace gibench
