/// Numbers and texts out of the bytes of a file that may end anywhere.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace gibench {

/// The number in four bytes from `place`, the most significant first; bytes past the end count as 0.
inline std::uint32_t big_endian(std::string_view bytes, std::size_t place) {
  std::uint32_t value = 0;
  for (std::size_t i = place; i < place + 4; ++i)
    value = value << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : std::uint32_t{0});
  return value;
}

/// Little-endian, from the front. What lies past the end is 0 or empty, and has_failed() from then on.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint32_t number() { return unsigned_of(4); }
  int integer() { return static_cast<int>(number()); }
  std::uint32_t byte() { return unsigned_of(1); }

  /// Up to the next zero byte, which is taken too.
  std::string_view text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) return fail();
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) return fail();
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::size_t left() const { return rest_.size(); }
  bool has_failed() const { return failed_; }
  bool is_next(char byte) const { return !rest_.empty() && rest_.front() == byte; }

 private:
  std::string_view fail() {
    failed_ = true;
    rest_ = {};
    return {};
  }
  std::uint32_t unsigned_of(std::size_t count) {
    std::uint32_t value = 0;
    const std::string_view bytes = take(count);
    for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return value;
  }

  std::string_view rest_;
  bool failed_ = false;
};

}  // namespace gibench
