/// Parallel loops over fixed chunks: the chunks depend on the count alone, so that sums taken per chunk and
/// added in chunk order are the same for any number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace gibench {

/// One chunk of a loop.
struct ChunkRange {
  std::size_t begin, end, chunk;  ///< items [begin, end) of chunk number `chunk`
};

/// Calls body once for every chunk of at most `chunk_size` items, on at most `threads` threads (0 = all cores).
/// Every thread runs with denormals flushed to zero. The first exception thrown by a body is thrown here.
void parallel_chunks(int threads, std::size_t count, std::size_t chunk_size, const std::function<void(const ChunkRange&)>& body);

constexpr std::size_t chunk_count(std::size_t count, std::size_t chunk_size) { return (count + chunk_size - 1) / chunk_size; }

/// The number of hardware threads that this process may use, at least 1.
int hardware_threads();

/// Flushes denormals to zero on this thread for its lifetime: Embree asks for it, and they are slow.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

}  // namespace gibench
