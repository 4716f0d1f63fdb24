/// The path tracer's entry in the registry.
#pragma once

#include "common/method/method.h"

namespace gibench {

MethodEntry pathtracer_entry();

}  // namespace gibench
