#include "bench/measure/cancellation.h"

#include "common/core/error.h"

namespace gibench {

const std::shared_ptr<std::atomic<bool>>& cancellation() {
  static const auto flag = std::make_shared<std::atomic<bool>>(false);
  return flag;
}

void stop_if_cancelled() {
  if (cancellation()->load()) throw WorkError("cancelled; nothing was written");
}

}  // namespace gibench
