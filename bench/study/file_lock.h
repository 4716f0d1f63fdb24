/// A lock that keeps processes of this program from working in one folder at the same time.
#pragma once

#include <filesystem>

namespace gibench {

/// Holds flock(2) on a file, which it makes with its folder; let go at the end of its life or of the process.
class FileLock {
 public:
  enum class WhenTaken { wait, refuse };
  /// With `refuse` throws InputError where another process holds it. Throws InputError where the file cannot be made,
  /// WorkError where the user asked to stop while it waited.
  FileLock(const std::filesystem::path& file, WhenTaken when_taken);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace gibench
