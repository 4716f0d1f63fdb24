#include "common/reference/folder_replacement.h"

#include <fcntl.h>
#include <stdio.h>

#include <cerrno>
#include <system_error>

#include "common/core/write_failure.h"

namespace gibench {

namespace {

bool rename_path(const std::filesystem::path& from, const std::filesystem::path& to) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

bool exchange(const std::filesystem::path& a, const std::filesystem::path& b) {
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

void remove_quietly(const std::filesystem::path& folder) {
  std::error_code ignored;  // what is left over takes room and does no harm
  std::filesystem::remove_all(folder, ignored);
}

[[noreturn]] void throw_not_replaced(const std::filesystem::path& target) {
  throw_write_failure(target, "cannot be replaced", errno, "name a folder that may be written to");
}

}  // namespace

std::filesystem::path previous_version(const std::filesystem::path& target) {
  std::filesystem::path name = target;
  name += ".previous";
  return name;
}

std::filesystem::path existing_version(const std::filesystem::path& target) {
  std::error_code unreadable;
  const std::filesystem::path previous = previous_version(target);
  return !std::filesystem::exists(target, unreadable) && std::filesystem::exists(previous, unreadable) ? previous : target;
}

void replace_folder(const std::filesystem::path& made, const std::filesystem::path& target) {
  const std::filesystem::path previous = previous_version(target);
  std::error_code unreadable;
  if (!std::filesystem::exists(target, unreadable)) {
    if (rename_path(made, target)) return remove_quietly(previous);
    if (errno != ENOTEMPTY && errno != EEXIST) throw_not_replaced(target);  // else another process made it in this moment
  }
  if (exchange(made, target)) {
    remove_quietly(made);
  } else {
    remove_quietly(previous);
    if (!rename_path(target, previous)) throw_not_replaced(target);
    if (!rename_path(made, target)) {
      rename_path(previous, target);
      throw_not_replaced(target);
    }
  }
  remove_quietly(previous);
}

}  // namespace gibench
