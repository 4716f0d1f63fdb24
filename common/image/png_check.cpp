#include "common/image/png_check.h"

#include <boost/crc.hpp>
#include <cstdint>

#include "common/image/byte_reader.h"

namespace gibench {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

}  // namespace

std::string png_damage(std::string_view bytes) {
  if (!bytes.starts_with(signature)) return {};
  bytes.remove_prefix(signature.size());
  for (;;) {  // a chunk is its data's length, four letters, the data, and a checksum of letters and data
    if (bytes.size() < 12 || bytes.size() - 12 < big_endian(bytes, 0)) return "the file is truncated";
    const std::size_t length = big_endian(bytes, 0);
    const std::string_view checked = bytes.substr(4, 4 + length);
    boost::crc_32_type checksum;
    checksum.process_bytes(checked.data(), checked.size());
    if (checksum.checksum() != big_endian(bytes, 8 + length)) return "a chunk's checksum does not fit its data";
    if (checked.starts_with("IEND")) return {};
    bytes.remove_prefix(12 + length);
  }
}

void for_each_png_chunk(std::string_view bytes, const std::function<bool(std::string_view type, std::string_view data)>& visit) {
  if (!bytes.starts_with(signature)) return;
  bytes.remove_prefix(signature.size());
  while (bytes.size() >= 12 && bytes.size() - 12 >= big_endian(bytes, 0)) {
    const std::size_t length = big_endian(bytes, 0);
    if (!visit(bytes.substr(4, 4), bytes.substr(8, length))) return;
    bytes.remove_prefix(12 + length);
  }
}

}  // namespace gibench
