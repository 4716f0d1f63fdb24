/// The signals of the program: SIGINT and SIGTERM ask the work to stop; a second one ends the program at once.
#pragma once

namespace gibench {

/// Installs the handlers; once, at the start of the program. The work sees it in bench/measure/cancellation.h.
void listen_for_cancellation();

}  // namespace gibench
