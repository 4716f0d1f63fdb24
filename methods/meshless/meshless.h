/// The meshless method's entry in the registry.
#pragma once

#include "common/method/method.h"

namespace gibench {

MethodEntry meshless_entry();

}  // namespace gibench
