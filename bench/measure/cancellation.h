/// SIGINT and SIGTERM stop the work, nothing half written; a second one ends the program at once.
#pragma once

#include <atomic>
#include <memory>

namespace gibench {

/// Installs the handlers; once, at the start of the program.
void listen_for_cancellation();

/// Set once the user asked to stop: hand it to TaskSettings::cancel.
const std::shared_ptr<std::atomic<bool>>& cancellation();

/// Throws WorkError where the user asked to stop.
void stop_if_cancelled();

}  // namespace gibench
