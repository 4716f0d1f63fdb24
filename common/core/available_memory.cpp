#include "common/core/available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

namespace gibench {

namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

/// The first number of a file that holds nothing else; none for the word "max".
std::optional<std::uint64_t> number_in(const std::string& file) {
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

/// The number after a name in a file of such pairs; 0 without it.
std::uint64_t named_number_in(const std::string& file, std::string_view wanted) {
  std::ifstream in(file);
  std::string name;
  for (std::uint64_t number = 0; in >> name >> number;)
    if (name == wanted) return number;
  return 0;
}

/// What a control group allows beyond what it uses; `cache` names the part of that which gives way: pages of files.
std::uint64_t left_of(const std::string& limit_file, const std::string& usage_file, const std::string& stat_file,
                      std::string_view cache) {
  const auto limit = number_in(limit_file), usage = number_in(usage_file);
  if (!limit || !usage) return unknown;
  const std::uint64_t used = *usage - std::min(*usage, named_number_in(stat_file, cache));
  return *limit > used ? *limit - used : 0;
}

}  // namespace

std::uint64_t available_memory() {
  const std::string second = "/sys/fs/cgroup/memory.", first = "/sys/fs/cgroup/memory/memory.";
  return std::min({available_to_the_system(), left_of(second + "max", second + "current", second + "stat", "inactive_file"),
                   left_of(first + "limit_in_bytes", first + "usage_in_bytes", first + "stat", "total_inactive_file")});
}

}  // namespace gibench
