/// A shard of the work, "i/n": this process does part i of n.
#pragma once

#include <string>

namespace gibench {

struct Shard {
  int index = 0, of = 1;
};

/// Parses "i/n" with 0 ≤ i < n. Throws InputError at --shard.
Shard parse_shard(const std::string& text);

}  // namespace gibench
