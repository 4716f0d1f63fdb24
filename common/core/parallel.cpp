#include "common/core/parallel.h"

#include <algorithm>
#include <thread>

#include "common/core/error.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif
#ifdef GIBENCH_STD_THREADS
#include <atomic>
#include <exception>
#include <mutex>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace gibench {

#ifdef __SSE__
FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040U); }  // FTZ | DAZ
FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }
#else  // the same answers to within denormals, and slower where there are any
FlushDenormals::FlushDenormals() : saved_(0) {}
FlushDenormals::~FlushDenormals() = default;
#endif

int hardware_threads() {
#ifdef GIBENCH_STD_THREADS
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
#else
  return std::max(1, tbb::this_task_arena::max_concurrency());
#endif
}

#ifdef GIBENCH_STD_THREADS
// The thread sanitizer reports false races inside TBB's templates: its preset runs loops on std::thread.
void parallel_chunks(int threads, std::size_t count, std::size_t chunk_size, const std::function<void(const ChunkRange&)>& body) {
  GIBENCH_CHECK(chunk_size > 0, "a chunk holds at least one item");
  const std::size_t chunks = chunk_count(count, chunk_size);
  std::atomic<std::size_t> next{0};
  std::exception_ptr first_error;
  std::mutex error_mutex;
  const auto work = [&] {
    const FlushDenormals flush;
    for (std::size_t chunk = next++; chunk < chunks; chunk = next++) try {
        body({chunk * chunk_size, std::min(count, (chunk + 1) * chunk_size), chunk});
      } catch (...) {
        const std::lock_guard lock(error_mutex);
        if (!first_error) first_error = std::current_exception();
        next = chunks;
      }
  };
  std::vector<std::thread> helpers;
  for (int i = 1; i < (threads > 0 ? threads : hardware_threads()); ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (first_error) std::rethrow_exception(first_error);
}
#else
void parallel_chunks(int threads, std::size_t count, std::size_t chunk_size, const std::function<void(const ChunkRange&)>& body) {
  GIBENCH_CHECK(chunk_size > 0, "a chunk holds at least one item");
  const std::size_t chunks = chunk_count(count, chunk_size);
  const auto run_chunk = [&](std::size_t chunk) {
    const FlushDenormals flush;
    body({chunk * chunk_size, std::min(count, (chunk + 1) * chunk_size), chunk});
  };
  if (chunks <= 1 || threads == 1) {  // an arena costs more than a small loop
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) run_chunk(chunk);
    return;
  }
  // More threads than cores gain nothing, and TBB would warn about them on stderr.
  tbb::task_arena arena(threads > 0 ? std::min(threads, hardware_threads()) : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, run_chunk, tbb::simple_partitioner()); });
}
#endif

}  // namespace gibench
