/// Result folders: whole or not there at all.
#pragma once

#include <filesystem>
#include <string>

namespace gibench {

/// A folder that appears under its name only when it is complete. What it holds is written into partial().
class OutputFolder {
 public:
  /// Throws InputError for a target that exists (unless `force` and it holds `marker`, the file by which gibench
  /// knows its own folders) and for one that cannot be made.
  OutputFolder(std::filesystem::path target, const std::string& marker, bool force);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& partial() const { return partial_; }
  /// Renames partial() to the target; an old target is exchanged for it in one step, then removed.
  void commit();

 private:
  std::filesystem::path target_, partial_;
};

}  // namespace gibench
