#include "common/core/did_you_mean.h"

#include <gtest/gtest.h>

namespace gibench::test {
namespace {

TEST(DidYouMean, TheNearestNameOrNothing) {
  EXPECT_EQ(did_you_mean("meshles", {"spectral", "meshless"}), "did you mean \"meshless\"? ");
  EXPECT_EQ(did_you_mean("MESHLESS", {"spectral", "meshless"}), "did you mean \"meshless\"? ");
  EXPECT_EQ(did_you_mean("qurey", {"run", "query"}), "did you mean \"query\"? ") << "two letters exchanged";
  EXPECT_EQ(did_you_mean("yreuq", {"run", "query"}), "");
  EXPECT_EQ(did_you_mean("radiosity", {"spectral", "meshless"}), "");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

}  // namespace
}  // namespace gibench::test
