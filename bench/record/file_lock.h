/// A lock that keeps processes of this program from working in one folder at the same time.
#pragma once

#include <filesystem>
#include <functional>

namespace gibench {

/// Holds flock(2) on a file, which it makes with its folder; at the end of its life it removes the file. A process that is killed
/// lets go of it as well, and what it leaves is an empty file that the next one takes.
class FileLock {
 public:
  enum class WhenTaken { wait, refuse };
  /// `guarded` is the folder that others are kept out of, for messages. With `refuse` throws InputError where another process
  /// holds it; with `wait` calls `between_tries` again and again, which may throw to end that. Throws as a write does where the
  /// file cannot be made.
  FileLock(std::filesystem::path file, const std::filesystem::path& guarded, WhenTaken when_taken,
           const std::function<void()>& between_tries = {});
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  /// False where another process holds it.
  bool take(const std::filesystem::path& guarded);

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace gibench
