/// From blocks to links: the transform of the kernel along senders and receivers.
#pragma once

#include "methods/wavelet/blocks.h"
#include "methods/wavelet/transport_operator.h"

namespace gibench::wavelet {

struct OperatorMaking {
  TransportOperator transport;
  std::uint64_t dropped_links = 0;
  double dropped_share = 0.0;  ///< root of the sum of squares of what was left out over that of all
};

/// The standard decomposition: functions of every level of the receiver times functions of every level of the sender, so that no
/// push or pull is needed. Only blocks hold samples; all else is the transform of them (the text's adaptive integration). Links
/// without a coefficient above `compression` are left out, but for those between roots' smooth functions.
OperatorMaking make_operator(const Elements& elements, const Blocks& blocks, double compression, Precision precision, Task& task);

}  // namespace gibench::wavelet
