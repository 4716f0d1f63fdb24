#include "common/core/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstdio>

namespace gibench {

std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed) {
  return XXH3_64bits_withSeed(data, size, seed);
}

struct KeyBuilder::State {
  XXH3_state_t xxh;
};

KeyBuilder::KeyBuilder() : state_(new State) { XXH3_128bits_reset(&state_->xxh); }
KeyBuilder::~KeyBuilder() { delete state_; }

KeyBuilder& KeyBuilder::add_raw(const void* data, std::size_t size) {
  if (size > 0) XXH3_128bits_update(&state_->xxh, data, size);
  return *this;
}

KeyBuilder& KeyBuilder::add(std::string_view text) { return add(text.size()).add_raw(text.data(), text.size()); }

std::string KeyBuilder::hex() const {
  const XXH128_hash_t digest = XXH3_128bits_digest(&state_->xxh);
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(digest.high64),
                static_cast<unsigned long long>(digest.low64));
  return text;
}

}  // namespace gibench
