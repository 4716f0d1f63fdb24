/// The memory that this process may still take.
#pragma once

#include <cstdint>

namespace gibench {

/// Bytes: what the system reports as available, or what the control group of this process leaves where that is less. The largest
/// number where the system does not say.
std::uint64_t available_memory();

}  // namespace gibench
