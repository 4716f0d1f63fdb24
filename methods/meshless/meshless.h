/// The meshless method's entry in the registry.
#pragma once

#include "common/method/method_entry.h"

namespace gibench {

MethodEntry meshless_entry();

}  // namespace gibench
