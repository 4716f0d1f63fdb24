#include "common/core/available_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>

namespace gibench {

namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

/// The first number of a file that holds nothing else; none for the word "max".
std::optional<std::uint64_t> number_in(const char* file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

std::uint64_t available_to_the_system() {
  std::ifstream in("/proc/meminfo");
  for (std::string name, unit; in >> name;) {
    std::uint64_t kibibytes = 0;
    in >> kibibytes;
    std::getline(in, unit);
    if (name == "MemAvailable:") return kibibytes * 1024;
  }
  return unknown;
}

std::uint64_t left_of(const char* limit_file, const char* usage_file) {
  const auto limit = number_in(limit_file), usage = number_in(usage_file);
  if (!limit || !usage) return unknown;
  return *limit > *usage ? *limit - *usage : 0;
}

}  // namespace

std::uint64_t available_memory() {
  return std::min({available_to_the_system(), left_of("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"),
                   left_of("/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes")});
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6) : fmt::format("{:.3g} GB", bytes / 1e9);
}

}  // namespace gibench
