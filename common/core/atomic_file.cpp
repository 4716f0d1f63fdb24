#include "common/core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "common/core/error.h"
#include "common/core/write_failure.h"

namespace gibench {

namespace {

/// Writes every byte and closes; false with errno set at the first failure. close() too may report a full disk.
bool write_all(std::FILE* out, std::span<const char> bytes) {
  if (out == nullptr) return false;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() && std::fflush(out) == 0;
  const int reason = errno;
  const bool closed = std::fclose(out) == 0;
  if (!written) errno = reason;
  return written && closed;
}

/// Opens what is there, without making or emptying anything.
std::FILE* open_as_it_is(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  return descriptor < 0 ? nullptr : fdopen(descriptor, "wb");
}

[[noreturn]] void throw_unwritable(const std::filesystem::path& file, int reason) {
  throw_write_failure(file, "cannot be written", reason, "name a file in a folder that exists and may be written to");
}

/// Whether bytes go through `file` to somewhere else: a pipe or a device like a terminal. Throws InputError for what no file of
/// ours can be: a folder, or a disk as a whole.
bool leads_elsewhere(const std::filesystem::path& file) {
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return false;
  if (S_ISDIR(status.st_mode)) throw InputError(file.string(), "is a folder", "name a file in it");
  if (S_ISBLK(status.st_mode)) throw InputError(file.string(), "is a block device", "name a file");
  return true;
}

}  // namespace

std::filesystem::path followed(std::filesystem::path path) {
  constexpr int most_links = 40;  // as the system follows
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(path, error); ++links) {
    if (links == most_links) throw InputError(path.string(), "leads through too many links", "name what it should lead to");
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path;
}

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> calls{0};
  constexpr std::size_t most_of_name = 200;  // bytes, so that the rest fits into a file name
  std::string name = ".";
  name.append(path.filename().string().substr(0, most_of_name)).append(".").append(std::to_string(getpid())).append(".");
  name.append(std::to_string(calls++)).append(".tmp");
  return path.parent_path() / name;
}

void write_file_atomically(const std::filesystem::path& file, std::span<const char> bytes) {
  if (leads_elsewhere(file)) {
    if (!write_all(open_as_it_is(file), bytes)) throw_unwritable(file, errno);
    return;
  }
  const std::filesystem::path target = followed(file), temporary = temporary_beside(target);
  if (!write_all(std::fopen(temporary.c_str(), "wb"), bytes) || std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw_unwritable(file, reason);
  }
}

std::string read_file(const std::filesystem::path& file) {
  const auto fail = [&](int reason) {
    throw InputError(file.string(), std::string("cannot be read (") + std::strerror(reason) + ")", "name a file that exists");
  };
  std::error_code no_folder;
  if (std::filesystem::is_directory(file, no_folder)) fail(EISDIR);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!in) fail(errno);
  std::string bytes;
  char block[1 << 16];
  for (std::size_t count = 0; (count = std::fread(block, 1, sizeof block, in.get())) > 0;) bytes.append(block, count);
  if (std::ferror(in.get()) != 0) fail(errno);
  return bytes;
}

}  // namespace gibench
