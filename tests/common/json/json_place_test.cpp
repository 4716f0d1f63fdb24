#include "common/json/json_place.h"

#include <gtest/gtest.h>

namespace gibench::test {
namespace {

TEST(JsonPlace, IsAPath) {
  const JsonPlace top("box.scene.json");
  EXPECT_EQ(top["objects"][2]["faces"][4][1].text(), "box.scene.json: $.objects[2].faces[4][1]");
  EXPECT_EQ(top["materials"]["old wood"].text(), "box.scene.json: $.materials[\"old wood\"]");
  EXPECT_EQ(top["materials"]["7"].text(), "box.scene.json: $.materials[\"7\"]");
}

}  // namespace
}  // namespace gibench::test
