#include "common/core/names.h"

#include <gtest/gtest.h>

namespace gibench::test {
namespace {

TEST(Names, NearestIsSuggested) {
  EXPECT_EQ(known_names("keys", "albdo", {"emission", "albedo"}), "did you mean \"albedo\"? keys: emission, albedo");
  EXPECT_EQ(known_names("keys", "ALBEDO", {"emission", "albedo"}), "did you mean \"albedo\"? keys: emission, albedo");
  EXPECT_EQ(known_names("keys", "colour", {"emission", "albedo"}), "keys: emission, albedo");
  EXPECT_EQ(known_names("lights", "x", {}), "there are no lights");
}

TEST(Names, LongListsAreCut) {
  std::vector<std::string> names;
  for (int i = 0; i < 25; ++i) names.push_back("object" + std::to_string(100 + i));
  const std::string text = known_names("objects", "something else", names);
  EXPECT_NE(text.find("object119, and 5 more"), std::string::npos) << text;
}

TEST(Names, UniqueNamesAreCounted) {
  UniqueNames names;
  EXPECT_EQ(names.take("leg#2"), "leg#2");
  EXPECT_EQ(names.take("leg"), "leg");
  EXPECT_EQ(names.take("leg"), "leg#2#2");
  EXPECT_EQ(names.take("leg"), "leg#3");
}

}  // namespace
}  // namespace gibench::test
