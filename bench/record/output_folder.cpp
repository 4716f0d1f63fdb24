#include "bench/record/output_folder.h"

#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/write_failure.h"
#include "common/reference/folder_replacement.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

/// "out/" is the folder out.
fs::path without_slash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

fs::path with_ending(fs::path path, const char* ending) { return path += ending; }

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, std::string marker, bool force, FileLock::WhenTaken when_taken,
                           const std::function<void()>& while_waiting)
    : target_(followed(without_slash(target))),
      partial_(with_ending(target_, ".partial")),
      marker_(std::move(marker)),
      force_(force) {
  check_target();  // before anything is made beside it
  lock_.emplace(with_ending(target_, ".lock"), target_, when_taken, while_waiting);
  check_target();
  std::error_code error;
  fs::remove_all(partial_, error);  // left by a run that was killed
  fs::create_directories(partial_, error);
  if (error) throw_write_failure(target_, "cannot be written", error.value(), "choose a folder that you may write to");
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
}

void OutputFolder::check_target() const {
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw InputError(target_.string(), "is not a folder", "choose another --out");
  if (fs::is_empty(target_, error)) return;
  if (!fs::exists(target_ / marker_, error))
    throw InputError(target_.string(), "exists and was not made by gibench", "choose another --out");
  if (!force_) throw InputError(target_.string(), "exists already", "choose another --out, or replace it with --force");
}

void OutputFolder::commit() {
  check_target();
  replace_folder(partial_, target_);
}

}  // namespace gibench
