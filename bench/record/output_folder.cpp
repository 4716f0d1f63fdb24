#include "bench/record/output_folder.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include "common/core/error.h"
#include "common/reference/folder_replacement.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void unwritable(const fs::path& folder, int error) {
  const std::string problem = std::string("cannot be written (") + std::strerror(error) + ")";
  if (error == ENOSPC || error == EDQUOT) throw WorkError(folder.string() + ": " + problem + "; free space and try again");
  throw InputError(folder.string(), problem, "choose a folder that you may write to");
}

}  // namespace

OutputFolder::OutputFolder(fs::path target, const std::string& marker, bool force) : target_(std::move(target)) {
  if (!target_.has_filename()) target_ = target_.parent_path();  // "out/"
  std::error_code error;
  const bool exists = fs::exists(target_, error);
  const bool empty = exists && fs::is_directory(target_, error) && fs::is_empty(target_, error);
  if (exists && !empty) {
    if (!fs::exists(target_ / marker, error))
      throw InputError(target_.string(), "exists and was not made by gibench", "choose another --out");
    if (!force) throw InputError(target_.string(), "exists already", "choose another --out, or replace it with --force");
  }
  partial_ = target_;
  partial_ += ".partial";
  fs::remove_all(partial_, error);  // left by a run that was killed
  fs::create_directories(partial_, error);
  if (error) unwritable(target_, error.value());
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
}

void OutputFolder::commit() { replace_folder(partial_, target_); }

}  // namespace gibench
