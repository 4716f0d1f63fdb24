/// Shards of a reference that do not make a whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/measure/reference_making.h"
#include "common/core/error.h"

namespace gibench {
namespace {

Reference shard(std::size_t replicas, std::uint64_t samples, float value) {
  Reference made;
  made.samples_per_replica = samples;
  made.surface.direct.replicas.assign(replicas, {Rgb(value)});
  made.surface.indirect = made.surface.direct;
  return made;
}

TEST(MergeShards, TakesReplicatesInTurn) {
  const Reference whole = merge_shards({shard(2, 16, 0.0F), shard(1, 16, 1.0F)});
  ASSERT_EQ(whole.surface.direct.count(), 3U);
  for (std::size_t r = 0; r < 3; ++r) EXPECT_EQ(whole.surface.indirect.replicas[r][0].r, r % 2 == 0 ? 0.0F : 1.0F);
}

TEST(MergeShards, RefusesShardsOfDifferentCalls) {
  const auto refused = [](const char* text) { return testing::ThrowsMessage<InputError>(testing::HasSubstr(text)); };
  EXPECT_THAT([] { merge_shards({shard(2, 16, 0.0F), shard(4, 16, 1.0F)}); }, refused("shard 0 of 2: has 2 replicates of 16"));
  EXPECT_THAT([] { merge_shards({shard(2, 16, 0.0F), shard(2, 32, 1.0F)}); }, refused("shard 1 of 2: has 2 replicates of 32"));
}

}  // namespace
}  // namespace gibench
