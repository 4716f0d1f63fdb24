#include "bench/study/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>

#include "bench/measure/cancellation.h"
#include "common/core/error.h"

namespace gibench {

namespace {

constexpr std::chrono::milliseconds between_tries{50};

}  // namespace

FileLock::FileLock(const std::filesystem::path& file, WhenTaken when_taken) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0)
    throw InputError(file.parent_path().string(), std::string("cannot be written (") + std::strerror(errno) + ")",
                     "choose a folder that you may write to");
  while (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (when_taken == WhenTaken::refuse || errno != EWOULDBLOCK) {
      close(descriptor_);
      throw InputError(file.parent_path().string(), "another gibench works in this folder", "wait for it to end");
    }
    if (cancellation()->load()) {
      close(descriptor_);
      stop_if_cancelled();
    }
    std::this_thread::sleep_for(between_tries);
  }
}

FileLock::~FileLock() { close(descriptor_); }

}  // namespace gibench
