/// The entry in the registry of relighting over a spectral mesh basis.
#pragma once

#include "common/method/method_entry.h"

namespace gibench {

MethodEntry spectral_entry();

}  // namespace gibench
