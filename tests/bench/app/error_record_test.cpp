#include "bench/record/error_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;

/// What a call tells the process that started it.
std::optional<ErrorRecord> reported(const Workshop& shop, const std::vector<std::string>& arguments) {
  shop.gibench(arguments, std::string(error_file_variable) + "=error.json");
  return read_error_record(shop / "error.json");
}

TEST(ErrorRecord, TellsTheParentByACodeWhatWentWrong) {
  const Workshop shop;
  shop.write("room.scene.json", room_scene());
  EXPECT_FALSE(reported(shop, {"check", "room.scene.json", "--quiet"}).has_value()) << "nothing went wrong";
  nlohmann::ordered_json lacking = room_scene();
  lacking["objects"].push_back({{"name", "statue"}, {"material", "wall"}, {"file", "statue-nowhere.obj"}});
  shop.write("lacking.scene.json", lacking);
  const auto missing = reported(shop, {"check", "lacking.scene.json"});
  ASSERT_TRUE(missing.has_value());
  EXPECT_EQ(missing->code, ErrorCode::missing_file);
  EXPECT_THAT(missing->message, HasSubstr("statue-nowhere.obj"));
  const auto wrong = reported(shop, {"run", "room.scene.json", "--method", "magic"});
  ASSERT_TRUE(wrong.has_value());
  EXPECT_EQ(wrong->code, ErrorCode::bad_input);
  EXPECT_THAT(wrong->message, HasSubstr("magic"));
}

}  // namespace
}  // namespace gibench::test
