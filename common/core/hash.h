/// 64- and 128-bit keys (xxHash XXH3): random streams, reference keys, study run keys.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace gibench {

/// Hash of raw bytes, the same on every little-endian machine.
std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed = 0);

/// Collects values in order and gives a 128-bit key as 32 hex digits.
class KeyBuilder {
 public:
  KeyBuilder();
  ~KeyBuilder();
  KeyBuilder(const KeyBuilder&) = delete;
  KeyBuilder& operator=(const KeyBuilder&) = delete;

  /// Adds the length and the characters, so that "ab","c" and "a","bc" differ.
  KeyBuilder& add(std::string_view text);
  template <class T>
  requires std::is_arithmetic_v<T> KeyBuilder& add(T value) { return add_raw(&value, sizeof value); }
  /// Elements without padding bytes only.
  template <class T>
  requires std::is_trivially_copyable_v<T> KeyBuilder& add(std::span<const T> values) {
    return add(values.size()).add_raw(values.data(), values.size_bytes());
  }

  std::string hex() const;

 private:
  KeyBuilder& add_raw(const void* data, std::size_t size);
  struct State;
  State* state_;
};

}  // namespace gibench
