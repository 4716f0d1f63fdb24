#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/bench/app/program.h"
#include "tests/support/exr_bytes.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;

ExrPart grey_picture(float value, const std::string& name = {}) {
  const std::vector<float> values(16 * 16, value);
  return {16, 16, {{"B", values}, {"G", values}, {"R", values}}, {}, name};
}

TEST(Compare, PicturesOfHugeValuesDiffer) {
  const Workshop shop;
  shop.write("huge.exr", exr_bytes({grey_picture(3e38F)}));
  shop.write("less.exr", exr_bytes({grey_picture(1e38F)}));
  const Outcome outcome = shop.gibench({"compare", "huge.exr", "less.exr", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto metrics = outcome.json();
  EXPECT_LT(metrics["psnr"]["value"].get<double>(), 20.0);
  EXPECT_LT(metrics["ssim"]["value"].get<double>(), 0.95);
  EXPECT_GT(metrics["hdr_flip"]["mean"].get<double>(), 0.1);
}

TEST(Compare, PartsThatAreNotReadAreNamedOnStderr) {
  const Workshop shop;
  const ExrPart depth{16, 16, {{"Z", std::vector<float>(16 * 16)}}, {}, "depth"};
  shop.write("parts.exr", exr_bytes({depth, grey_picture(0.5F, "beauty")}));
  shop.write("one.exr", exr_bytes({grey_picture(0.5F)}));
  const Outcome outcome = shop.gibench({"compare", "one.exr", "parts.exr", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(outcome.json()["rmse"]["value"], 0.0);
  EXPECT_EQ(outcome.error_lines(), 1U);
  EXPECT_THAT(outcome.error, HasSubstr("parts.exr: of its parts only \"beauty\" is read, not \"depth\""));
  EXPECT_EQ(shop.gibench({"compare", "one.exr", "parts.exr", "--quiet"}).error, "");
}

TEST(Compare, AHeaderThatAsksForGigabytesIsRefused) {
  const Workshop shop;
  std::string bytes = exr_bytes({grey_picture(0.5F)});
  const std::string attribute("screenWindowWidth\0float\0", 24);
  bytes.replace(bytes.find(attribute) + attribute.size(), 4, "\x0b\x72\xd5\x4f");  // 1.25 GiB
  shop.write("long.exr", bytes);
  expect_bad_input(shop.gibench({"compare", "long.exr", "long.exr"}), {"long.exr", "is longer than the file"});
}

}  // namespace
}  // namespace gibench::test
