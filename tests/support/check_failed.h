/// A matcher of calls that break an invariant.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "common/core/error.h"

namespace gibench::test {

/// Matches a call without arguments that throws CheckFailed with `text` in its message.
inline auto fails_check(const std::string& text) { return testing::ThrowsMessage<CheckFailed>(testing::HasSubstr(text)); }

}  // namespace gibench::test
