/// The entry in the registry of relighting over a spectral mesh basis.
#pragma once

#include "common/method/method.h"

namespace gibench {

MethodEntry spectral_entry();

}  // namespace gibench
