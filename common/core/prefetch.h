/// Hint to the processor that memory will be read soon.
#pragma once

namespace gibench {

/// Starts to fetch what lies at `address`, which may be anything: nothing is read yet, and no result changes.
inline void prefetch(const void* address) { __builtin_prefetch(address); }

}  // namespace gibench
