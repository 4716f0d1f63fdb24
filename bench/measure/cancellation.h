/// The user's request to stop: work then ends, and nothing is left half written.
#pragma once

#include <atomic>
#include <memory>

namespace gibench {

/// Set once the user asked to stop: hand it to TaskSettings::cancel.
const std::shared_ptr<std::atomic<bool>>& cancellation();

/// Throws WorkError where the user asked to stop.
void stop_if_cancelled();

}  // namespace gibench
