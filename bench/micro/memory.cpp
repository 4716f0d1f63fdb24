/// How fast memory is copied: the floor under everything that streams its data.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

#include "common/core/parallel.h"

namespace gibench::micro {
namespace {

constexpr std::size_t chunk_bytes = 1U << 20;

/// Arguments: bytes of the source, threads. Bytes per second are those read and those written (as STREAM counts).
void copy(benchmark::State& state) {
  const auto bytes = static_cast<std::size_t>(state.range(0));
  const auto threads = static_cast<int>(state.range(1));
  std::vector<unsigned char> from(bytes, 1), to(bytes, 0);
  for (auto _ : state) {
    parallel_chunks(threads, bytes, chunk_bytes, [&](const ChunkRange& range) {
      std::memcpy(to.data() + range.begin, from.data() + range.begin, range.end - range.begin);
    });
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(2 * bytes) * static_cast<std::int64_t>(state.iterations()));
}
// 4 MB fits the last-level cache of most machines, 256 MB that of none.
BENCHMARK(copy)->ArgsProduct({{4 << 20, 256 << 20}, {1, 2}})->ArgNames({"bytes", "threads"})->UseRealTime();

}  // namespace
}  // namespace gibench::micro
