#include "common/core/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/core/random.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

TEST(ParallelChunks, VisitsEveryItemOnceInFixedChunks) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> visits(1003);
    std::vector<ChunkRange> ranges(chunk_count(visits.size(), 100), ChunkRange{0, 0, 0});
    parallel_chunks(threads, visits.size(), 100, [&](const ChunkRange& range) {
      ranges[range.chunk] = range;
      for (std::size_t i = range.begin; i < range.end; ++i) ++visits[i];
    });
    for (const std::atomic<int>& count : visits) ASSERT_EQ(count.load(), 1);
    ASSERT_EQ(ranges.size(), 11U);
    for (std::size_t chunk = 0; chunk < ranges.size(); ++chunk) {
      EXPECT_EQ(ranges[chunk].begin, 100 * chunk);
      EXPECT_EQ(ranges[chunk].end, std::min<std::size_t>(1003, 100 * chunk + 100));
    }
  }
}

TEST(ParallelChunks, NothingToDoCallsNobody) {
  parallel_chunks(2, 0, 16, [](const ChunkRange&) { FAIL() << "called for an empty range"; });
}

/// Sums taken per chunk and added in chunk order have the same bits for any number of threads.
TEST(ParallelChunks, ChunkedSumsDoNotDependOnTheThreads) {
  const auto sum_with = [](int threads) {
    constexpr std::size_t count = 100'000, chunk = 77;
    std::vector<float> partial(chunk_count(count, chunk));
    parallel_chunks(threads, count, chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) partial[range.chunk] += RandomStream(1, 2, i).next_float();
    });
    return std::accumulate(partial.begin(), partial.end(), 0.0F);
  };
  const float one = sum_with(1);
  EXPECT_EQ(one, sum_with(2));
  EXPECT_EQ(one, sum_with(7));
  EXPECT_NEAR(one, 50'000.0F, 500.0F);
}

TEST(ParallelChunks, PassesOnTheFirstException) {
  const auto run = [](int threads) {
    parallel_chunks(threads, 1000, 10, [](const ChunkRange& range) {
      if (range.chunk == 3) throw std::runtime_error("chunk three");
    });
  };
  for (const int threads : {1, 2}) try {
      run(threads);
      ADD_FAILURE() << "the exception was lost";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), "chunk three");
    }
}

TEST(ParallelChunks, BodiesFlushDenormalsAndTheCallerDoesNot) {
  volatile float smallest_normal = 1.17549435e-38F;
  std::vector<float> halves(64, -1.0F);
  parallel_chunks(2, halves.size(), 1, [&](const ChunkRange& range) { halves[range.begin] = smallest_normal * 0.5F; });
  for (const float half : halves) EXPECT_EQ(half, 0.0F);
  EXPECT_GT(smallest_normal * 0.5F, 0.0F);
}

TEST(ParallelChunks, RefusesChunksOfNothing) {
  EXPECT_THAT([&] { parallel_chunks(1, 10, 0, [](const ChunkRange&) {}); }, test::fails_check("a chunk holds at least one item"));
}

TEST(HardwareThreads, IsAtLeastOne) { EXPECT_GE(hardware_threads(), 1); }

}  // namespace
}  // namespace gibench
