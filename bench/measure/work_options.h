/// The options of all work: its seed, its threads, and where its progress is shown.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "bench/measure/progress.h"

namespace gibench {

struct WorkOptions {
  std::uint64_t seed = 1;
  int threads = 0;             ///< 0: all cores
  bool quiet = false;          ///< no progress and no notes
  ShowProgress show_progress;  ///< empty: shown nowhere

  /// The progress of a piece of work; one that shows nothing where the work is to be quiet.
  std::shared_ptr<Progress> progress_of(const std::string& title) const {
    return quiet || !show_progress ? std::make_shared<Progress>() : show_progress(title);
  }
};

}  // namespace gibench
