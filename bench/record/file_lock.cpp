#include "bench/record/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>

#include "common/core/error.h"
#include "common/core/write_failure.h"

namespace gibench {

namespace {

constexpr std::chrono::milliseconds between_tries{50};
constexpr const char* remedy = "choose a folder that you may write to";

/// Whether the descriptor is of the file that has the name now: who held it before may have removed that one.
bool is_of(const std::filesystem::path& file, int descriptor) {
  struct stat opened = {}, named = {};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

FileLock::FileLock(std::filesystem::path file, const std::filesystem::path& guarded, WhenTaken when_taken,
                   const std::function<void()>& while_waiting)
    : file_(std::move(file)) {
  while (!take(guarded)) {
    if (when_taken == WhenTaken::refuse)
      throw InputError(guarded.string(), "another gibench works in this folder", "wait for it to end");
    if (while_waiting) while_waiting();
    std::this_thread::sleep_for(between_tries);
  }
}

bool FileLock::take(const std::filesystem::path& guarded) {
  for (;;) {
    std::error_code failure;
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path(), failure);
    if (failure) throw_write_failure(guarded, "cannot be written", failure.value(), remedy);
    const int descriptor = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0) throw_write_failure(guarded, "cannot be written", errno, remedy);
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_of(file_, descriptor)) {
      descriptor_ = descriptor;
      return true;
    }
    const int reason = errno;
    const bool removed = !is_of(file_, descriptor);
    close(descriptor);
    if (removed) continue;
    if (reason == EWOULDBLOCK) return false;
    if (reason != EINTR) throw_write_failure(guarded, "cannot be locked", reason, "choose a folder on another file system");
  }
}

FileLock::~FileLock() {
  // While it is held: who waits for it sees that its file is gone, and makes another.
  if (is_of(file_, descriptor_)) unlink(file_.c_str());
  close(descriptor_);
}

}  // namespace gibench
