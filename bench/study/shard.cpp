#include "bench/study/shard.h"

#include <charconv>

#include "common/core/error.h"

namespace gibench {

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char *begin = text.data(), *end = begin + text.size();
  const auto [slash, error] = std::from_chars(begin, end, shard.index);
  const bool parsed = error == std::errc() && slash != end && *slash == '/';
  const auto [rest, second] = parsed ? std::from_chars(slash + 1, end, shard.of) : std::from_chars_result{end, error};
  if (!parsed || second != std::errc() || rest != end || shard.index < 0 || shard.index >= shard.of)
    throw InputError("--shard", "'" + text + "' is not of the form i/n", "write i/n with 0 <= i < n, as 0/4");
  return shard;
}

}  // namespace gibench
