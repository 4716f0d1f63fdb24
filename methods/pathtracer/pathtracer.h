/// The path tracer's entry in the registry.
#pragma once

#include "common/method/method_entry.h"

namespace gibench {

MethodEntry pathtracer_entry();

}  // namespace gibench
