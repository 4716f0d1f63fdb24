#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "common/core/counters.h"
#include "common/core/hash.h"

namespace gibench {
namespace {

TEST(HashBytes, MatchesThePublishedXxh3) {
  // XXH3_64bits of nothing, from the xxHash specification's reference implementation.
  EXPECT_EQ(hash_bytes("", 0), 0x2d06800538d394c2ULL);
  EXPECT_NE(hash_bytes("a", 1), hash_bytes("b", 1));
  EXPECT_NE(hash_bytes("a", 1, 1), hash_bytes("a", 1, 2));
}

TEST(KeyBuilder, GivesThirtyTwoHexDigitsThatRepeat) {
  const auto key = [] { return KeyBuilder().add("scene").add(3).add(1.5F).hex(); };
  EXPECT_EQ(key(), key());
  EXPECT_EQ(key().size(), 32U);
  EXPECT_EQ(key().find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(KeyBuilder, BordersBetweenTextsCount) {
  std::set<std::string> keys;
  keys.insert(KeyBuilder().add("ab").add("c").hex());
  keys.insert(KeyBuilder().add("a").add("bc").hex());
  keys.insert(KeyBuilder().add("abc").hex());
  keys.insert(KeyBuilder().add("abc").add("").hex());
  EXPECT_EQ(keys.size(), 4U);
}

TEST(KeyBuilder, BordersBetweenSpansCount) {
  const std::vector<float> one{1.0F}, two{1.0F, 2.0F}, last{2.0F}, none;
  const auto key = [](const std::vector<float>& a, const std::vector<float>& b) {
    return KeyBuilder().add(std::span<const float>(a)).add(std::span<const float>(b)).hex();
  };
  EXPECT_EQ((std::set<std::string>{key(one, last), key(two, none), key(none, two)}).size(), 3U);
}

TEST(Counters, AddAndTellWhatChanged) {
  Counters counters;
  EXPECT_EQ(counters["rays"], 0U);
  counters.add("rays", 5);
  counters.add("links", 2);
  const Counters before = counters;
  counters.add("rays", 3);
  counters.add("bins", 1);
  EXPECT_EQ(counters["rays"], 8U);
  const Counters change = counters.since(before);
  EXPECT_EQ(change["rays"], 3U);
  EXPECT_EQ(change["bins"], 1U);
  EXPECT_EQ(change.values().size(), 2U) << "what did not change is absent";
}

}  // namespace
}  // namespace gibench
