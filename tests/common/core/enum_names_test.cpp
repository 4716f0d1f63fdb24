#include "common/core/enum_names.h"

#include <gtest/gtest.h>

#include <array>

namespace gibench {
namespace {

enum class Fruit { apple, pear };
constexpr std::array all_fruits{Fruit::apple, Fruit::pear};
const char* to_string(Fruit fruit) { return fruit == Fruit::apple ? "apple" : "pear"; }

TEST(EnumNames, EachIsFoundByItsOwn) {
  for (const Fruit fruit : all_fruits) EXPECT_EQ(find_named(all_fruits, to_string(fruit)), fruit);
  EXPECT_EQ(find_named(all_fruits, "pea"), std::nullopt);
  EXPECT_EQ(find_named(all_fruits, ""), std::nullopt);
  EXPECT_EQ(list_names(all_fruits), "apple, pear");
}

}  // namespace
}  // namespace gibench
