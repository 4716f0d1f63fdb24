/// The reading of a study folder into records.
#pragma once

#include <filesystem>
#include <functional>

#include "reports/collect/study.h"

namespace gibench::report {

/// Asked before each of the many steps of a large report; stops it by throwing.
using MayGoOn = std::function<void()>;

/// Throws InputError for a folder without a readable study manifest. A damaged run record makes its run a failed
/// one that says why, with a line in the study's warnings.
Study collect_study(
    const std::filesystem::path& folder, const MayGoOn& may_go_on = [] {});

/// Adds to `run` what its result.json says. Throws InputError, the run unchanged, for a record that cannot be read.
void read_result(const std::filesystem::path& file, StudyRun& run);
/// Adds to `relight` what its relight.json says. Throws InputError for a record that cannot be read.
void read_relight(const std::filesystem::path& file, StudyRelight& relight);

}  // namespace gibench::report
