/// The error of a stored reference that is not as it was written.
#pragma once

#include <filesystem>
#include <string>

#include "common/core/error.h"

namespace gibench {

/// Making it anew remedies it.
class DamagedReference : public InputError {
 public:
  DamagedReference(const std::filesystem::path& file, const std::string& problem)
      : InputError(file.string(), "the stored reference is damaged: " + problem,
                   "make it again with gibench reference and --remake-damaged") {}
};

}  // namespace gibench
