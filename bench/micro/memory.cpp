/// How fast memory is copied: the floor under everything that streams its data.
#include <benchmark/benchmark.h>

#include <cstring>
#include <numeric>
#include <vector>

#include "bench/micro/cpu_clock.h"
#include "common/core/parallel.h"

namespace gibench::micro {
namespace {

constexpr std::size_t chunk_bytes = 1U << 20;

/// Arguments: bytes of the source, threads. Bytes per second are those read and those written (as STREAM counts), by
/// all threads together, were each of them never interrupted.
void copy(benchmark::State& state) {
  const auto bytes = static_cast<std::size_t>(state.range(0));
  const auto threads = static_cast<int>(state.range(1));
  std::vector<unsigned char> from(bytes, 1), to(bytes, 0);
  std::vector<double> seconds(chunk_count(bytes, chunk_bytes));
  for (auto _ : state) {
    parallel_chunks(threads, bytes, chunk_bytes, [&](const ChunkRange& range) {
      const double start = thread_seconds();
      std::memcpy(to.data() + range.begin, from.data() + range.begin, range.end - range.begin);
      benchmark::ClobberMemory();
      seconds[range.chunk] = thread_seconds() - start;
    });
    state.SetIterationTime(std::accumulate(seconds.begin(), seconds.end(), 0.0) / threads);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(2 * bytes) * static_cast<std::int64_t>(state.iterations()));
}
// 4 MB fits the last-level cache of most machines, 256 MB that of none.
BENCHMARK(copy)->ArgsProduct({{4 << 20, 256 << 20}, {1, 2}})->ArgNames({"bytes", "threads"})->UseManualTime();

}  // namespace
}  // namespace gibench::micro
