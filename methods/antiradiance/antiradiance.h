/// Disc elements: ambient accessibility, one bounce, and hierarchical radiosity with traced, implicit or no visibility.
#pragma once

#include "common/method/method_entry.h"

namespace gibench {

MethodEntry antiradiance_entry();

}  // namespace gibench
