#include "bench/app/value_kinds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

namespace gibench {

CLI::Option* take_one_of(CLI::Option* option, const std::vector<std::string>& words) {
  // The type says already what CLI11 would add.
  return option->type_name(fmt::format("{}", fmt::join(words, "|")))->check(CLI::IsMember(words).description(""));
}

}  // namespace gibench
