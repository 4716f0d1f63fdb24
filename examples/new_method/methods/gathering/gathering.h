/// Gathering's entry in the registry.
#pragma once

#include "common/method/method_entry.h"

namespace gibench {

MethodEntry gathering_entry();

}  // namespace gibench
