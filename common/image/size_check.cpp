#include "common/image/size_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "common/image/hdr_header.h"

namespace gibench {

namespace {

double big_endian(std::string_view bytes, std::size_t place, std::size_t count) {
  double value = 0.0;
  for (std::size_t i = 0; i < count && place + i < bytes.size(); ++i)
    value = 256.0 * value + static_cast<unsigned char>(bytes[place + i]);
  return value;
}

/// Deflate makes 1032 bytes of one at best. The size and the kind of pixel stand at fixed places of the first chunk.
double fewest_bytes_of_png(std::string_view bytes) {
  const double width = big_endian(bytes, 16, 4), height = big_endian(bytes, 20, 4), depth = big_endian(bytes, 24, 1);
  const double kind = big_endian(bytes, 25, 1);
  const double channels = kind == 2.0 ? 3.0 : kind == 4.0 ? 2.0 : kind == 6.0 ? 4.0 : 1.0;
  return height * (1.0 + std::ceil(width * channels * depth / 8.0)) / 1032.0;
}

/// A row of runs: four bytes at its beginning, and two for 127 equal values of each of four channels.
double fewest_bytes_of_hdr(std::string_view bytes) {
  const HdrHeader header = read_hdr_header(bytes);
  const bool has_runs = header.width >= 8.0 && header.width <= 32767.0;
  return header.height * (has_runs ? 4.0 + 8.0 * std::ceil(header.width / 127.0) : 4.0 * header.width);
}

/// The next word of a PNM header; a comment runs from # to the end of its line.
std::string next_word(std::istringstream& header) {
  std::string word, comment;
  while (header >> word && word.front() == '#') std::getline(header, comment);
  return word;
}

double number_in(const std::string& word) {
  double number = 0.0;
  return std::istringstream(word) >> number ? number : 0.0;
}

double fewest_bytes_of_pnm(std::string_view bytes) {
  std::istringstream header(std::string(bytes.substr(0, std::min<std::size_t>(bytes.size(), 4096))));
  const std::string kind = next_word(header);
  const double width = number_in(next_word(header)), height = number_in(next_word(header));
  const double channels = kind == "P3" || kind == "P6" || kind == "PF" ? 3.0 : 1.0;
  const double samples = width * height * channels;
  if (kind == "PF" || kind == "Pf") return 4.0 * samples;
  if (kind == "P4") return std::ceil(width / 8.0) * height;
  if (kind == "P1") return samples;
  const double largest = number_in(next_word(header));
  if (kind == "P2" || kind == "P3") return 2.0 * samples - 1.0;  // a digit and a blank
  return largest > 255.0 ? 2.0 * samples : samples;
}

/// A block of 8 × 8 pixels takes a bit at least, where Huffman codes are used (start-of-frame markers 0 to 2).
double fewest_bytes_of_jpeg(std::string_view bytes) {
  std::size_t place = 2;
  while (place + 9 < bytes.size() && bytes[place] == '\xff') {
    const auto marker = static_cast<unsigned char>(bytes[place + 1]);
    if (marker >= 0xc0 && marker <= 0xc2) return big_endian(bytes, place + 5, 2) * big_endian(bytes, place + 7, 2) / 512.0;
    if (marker == 0xff) ++place;  // padding
    else place += 2 + static_cast<std::size_t>(big_endian(bytes, place + 2, 2));
  }
  return 0.0;
}

double fewest_bytes(std::string_view bytes, std::string_view format) {
  if (format == "png") return fewest_bytes_of_png(bytes);
  if (format == "hdr") return fewest_bytes_of_hdr(bytes);
  if (format == "pnm") return fewest_bytes_of_pnm(bytes);
  if (format == "jpeg") return fewest_bytes_of_jpeg(bytes);
  return 0.0;
}

}  // namespace

std::string size_damage(std::string_view bytes, std::string_view format) {
  const bool fits = fewest_bytes(bytes, format) <= static_cast<double>(bytes.size());
  return fits ? "" : "its header states more pixels than a file of its length can hold";
}

}  // namespace gibench
