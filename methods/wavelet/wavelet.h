/// The method `wavelet`: radiance transport operators in a Haar basis, made once and lit again and again.
#pragma once

#include "common/method/method_entry.h"

namespace gibench {

MethodEntry wavelet_entry();

}  // namespace gibench
