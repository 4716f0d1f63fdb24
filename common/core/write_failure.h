/// The failure of a write: a full disk is failed work, anything else a wrong call.
#pragma once

#include <filesystem>
#include <string>

namespace gibench {

/// Throws for what the system says of a write, `reason` being errno: WorkError where it has no room left or the device fails
/// (ENOSPC, EDQUOT, EIO), since neither call nor input is wrong then; else InputError with the remedy. `problem` is what could
/// not be done: "cannot be written".
[[noreturn]] void throw_write_failure(const std::filesystem::path& place, const std::string& problem, int reason,
                                      const std::string& remedy);

}  // namespace gibench
