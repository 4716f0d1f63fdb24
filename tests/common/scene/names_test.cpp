#include "common/scene/names.h"

#include <gtest/gtest.h>

#include "common/scene/json_place.h"

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

TEST(JsonPlace, IsAPath) {
  const JsonPlace top("box.scene.json");
  EXPECT_EQ(top["objects"][2]["faces"][4][1].text(), "box.scene.json: $.objects[2].faces[4][1]");
  EXPECT_EQ(top["materials"]["old wood"].text(), "box.scene.json: $.materials[\"old wood\"]");
  EXPECT_EQ(top["materials"]["7"].text(), "box.scene.json: $.materials[\"7\"]");
}

}  // namespace
}  // namespace gibench::test
