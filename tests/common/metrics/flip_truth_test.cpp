/// FLIP against values of the authors' tool. The pictures are not part of the project: GIBENCH_TRUTH names the folder
/// whose flip/values.json lists them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/core/atomic_file.h"
#include "common/image/image_file.h"
#include "common/metrics/flip.h"
#include "common/metrics/hdr_flip.h"

namespace gibench {
namespace {

constexpr double tolerance = 5e-4;

void expect_statistics(const FlipStatistics& found, const nlohmann::json& expected, const std::string& name) {
  EXPECT_NEAR(found.mean, expected.at("mean").get<double>(), tolerance) << name;
  EXPECT_NEAR(found.weighted_median, expected.at("weighted_median").get<double>(), tolerance) << name;
  EXPECT_NEAR(found.quartile_1, expected.at("quartile_1").get<double>(), tolerance) << name;
  EXPECT_NEAR(found.quartile_3, expected.at("quartile_3").get<double>(), tolerance) << name;
  EXPECT_NEAR(found.min, expected.at("min").get<double>(), tolerance) << name;
  EXPECT_NEAR(found.max, expected.at("max").get<double>(), tolerance) << name;
}

ExposureRange range_of(const nlohmann::json& expected, const Image& reference) {
  const auto start = expected.at("start_exposure").get<float>(), stop = expected.at("stop_exposure").get<float>();
  const auto count = expected.at("exposures").get<int>();
  if (!expected.value("automatic_exposures", false)) return {start, stop, count};
  const ExposureRange found = automatic_exposures(reference.pixels);
  EXPECT_NEAR(found.start, start, tolerance);
  EXPECT_NEAR(found.stop, stop, tolerance);
  EXPECT_EQ(found.count, count);
  return found;
}

TEST(FlipTruth, MatchesTheAuthorsTool) {
  const char* const truth = std::getenv("GIBENCH_TRUTH");
  if (truth == nullptr) GTEST_SKIP() << "GIBENCH_TRUTH is not set: no picture pairs with values of the authors' tool";
  const std::filesystem::path folder = std::filesystem::path(truth) / "flip";
  const nlohmann::json cases = nlohmann::json::parse(read_file(folder / "values.json"));
  ASSERT_FALSE(cases.empty());
  for (const nlohmann::json& expected : cases) {
    const Image reference = read_image(folder / expected.at("reference").get<std::string>());
    const Image test = read_image(folder / expected.at("test").get<std::string>());
    const auto ppd = expected.at("pixels_per_degree").get<float>();
    const bool hdr = expected.at("kind") == "hdr";
    const std::vector<float> errors = hdr ? hdr_flip_map(reference.width, reference.height, reference.pixels, test.pixels,
                                                         range_of(expected, reference), ToneMapper::aces, ppd)
                                          : flip_map(reference.width, reference.height, reference.pixels, test.pixels, ppd);
    expect_statistics(flip_statistics(errors), expected, expected.dump());
  }
}

}  // namespace
}  // namespace gibench
