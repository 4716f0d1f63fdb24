/// PNG files made by hand, byte by byte.
#pragma once

#include <boost/crc.hpp>
#include <cstdint>
#include <string>

namespace gibench::test::png_bytes {

inline std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xffU);
  return bytes;
}

inline std::string chunk(const std::string& letters_and_data) {
  boost::crc_32_type checksum;
  checksum.process_bytes(letters_and_data.data(), letters_and_data.size());
  return big_endian(static_cast<std::uint32_t>(letters_and_data.size() - 4)) + letters_and_data + big_endian(checksum.checksum());
}

/// A zlib stream of one block that is not compressed.
inline std::string stored(const std::string& data) {
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521U;
    b = (b + a) % 65521U;
  }
  const auto length = static_cast<unsigned>(data.size());
  std::string stream = "\x78\x01\x01";
  for (const unsigned half : {length, ~length}) {
    stream += static_cast<char>(half & 0xffU);
    stream += static_cast<char>(half >> 8 & 0xffU);
  }
  return stream + data + big_endian(b << 16 | a);
}

/// `kind`: 0 grey, 2 colours, 3 palette; `rows`: each begins with the number of its filter, 0.
inline std::string png(std::uint32_t width, std::uint32_t height, char depth, char kind, const std::string& more_chunks,
                       const std::string& pixel_stream) {
  return std::string("\x89PNG\r\n\x1a\n", 8) +
         chunk("IHDR" + big_endian(width) + big_endian(height) + depth + kind + std::string(3, '\0')) + more_chunks +
         chunk("IDAT" + pixel_stream) + chunk("IEND");
}

}  // namespace gibench::test::png_bytes
