/// Result folders: whole or not there at all.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "bench/record/file_lock.h"

namespace gibench {

/// A folder that appears under its name only when it is complete. What it holds is written into partial(). While it is made,
/// TARGET.lock beside it keeps others from making it too. A target that is a link stands for what it leads to.
class OutputFolder {
 public:
  /// Throws InputError for a target that is no folder, that exists (unless `force` and it holds `marker`, the file by which
  /// gibench knows its own folders), that another process makes (unless it is to be waited for), and for one that cannot be
  /// made; WorkError for a full disk. `while_waiting` may throw to end waiting.
  OutputFolder(const std::filesystem::path& target, std::string marker, bool force,
               FileLock::WhenTaken when_taken = FileLock::WhenTaken::refuse, const std::function<void()>& while_waiting = {});
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& partial() const { return partial_; }
  /// Renames partial() to the target; an old target is exchanged for it in one step, then removed. InputError where the target
  /// became something else meanwhile.
  void commit();

 private:
  void check_target() const;

  std::filesystem::path target_, partial_;
  std::string marker_;
  bool force_;
  std::optional<FileLock> lock_;
};

}  // namespace gibench
