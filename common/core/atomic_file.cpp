#include "common/core/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "common/core/error.h"

namespace gibench {

namespace {

/// Writes every byte and closes; false with errno set at the first failure. close() too may report a full disk.
bool write_all(const std::filesystem::path& file, std::span<const char> bytes) {
  std::FILE* const out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) return false;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() && std::fflush(out) == 0;
  const int reason = errno;
  const bool closed = std::fclose(out) == 0;
  if (!written) errno = reason;
  return written && closed;
}

[[noreturn]] void throw_unwritable(const std::filesystem::path& file, int reason) {
  throw InputError(file.string(), std::string("cannot be written (") + std::strerror(reason) + ")",
                   "name a file in a folder that exists, may be written to and has room");
}

}  // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> calls{0};
  std::string name = ".";
  name.append(path.filename().string()).append(".").append(std::to_string(getpid())).append(".");
  name.append(std::to_string(calls++)).append(".tmp");
  return path.parent_path() / name;
}

void write_file_atomically(const std::filesystem::path& file, std::span<const char> bytes) {
  const std::filesystem::path temporary = temporary_beside(file);
  if (!write_all(temporary, bytes) || std::rename(temporary.c_str(), file.c_str()) != 0) {
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
