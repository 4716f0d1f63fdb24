#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using Json = nlohmann::ordered_json;

const double pi = std::numbers::pi;

Json floor_query(const std::string& quantity) {
  return {{"id", quantity}, {"point", {0.4, 0.0, 0.3}}, {"normal", {0, 1, 0}}, {"quantity", quantity}};
}

Outcome ask(const Workshop& shop, const Json& queries, const std::vector<std::string>& more = {}) {
  shop.write("points.json", Json{{"queries", queries}});
  std::vector<std::string> arguments{"query", "furnace.scene.json", "--method", "pathtracer",
                                     "--set", "samples=1024",       "--points", "points.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return shop.gibench(arguments);
}

/// Within four standard errors, or a ten thousandth where the method is exact.
void expect_value(const Json& answer, double expected) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double tolerance =
        answer["standard_error"].is_array() ? 4.0 * answer["standard_error"][c].get<double>() : 0.02 * expected;
    EXPECT_NEAR(answer["value"][c].get<double>(), expected, tolerance + 1e-4 * expected) << answer;
  }
}

// A closed furnace of emitted radiance 1 and albedo 1/2: radiance 2 everywhere, irradiance 2 pi, radiosity 2 pi.
TEST(Query, AFurnaceGivesItsClosedForm) {
  const Workshop shop;
  Json radiance = floor_query("radiance");
  radiance["direction"] = {0, 1, 0};
  Json direct = floor_query("irradiance"), indirect = floor_query("irradiance");
  direct["id"] = "direct", direct["component"] = "direct";
  indirect["id"] = "indirect", indirect["component"] = "indirect";
  const Outcome outcome =
      ask(shop, {floor_query("irradiance"), radiance, floor_query("radiosity"), direct, indirect, floor_query("accessibility")},
          {"--out", "answers.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json answers = shop.read_json("answers.json")["queries"];
  ASSERT_EQ(answers.size(), 6U);
  EXPECT_EQ(answers[0]["id"], "irradiance");
  expect_value(answers[0], 2.0 * pi);
  expect_value(answers[1], 2.0);
  expect_value(answers[2], 2.0 * pi);
  expect_value(answers[3], pi);
  expect_value(answers[4], pi);
  expect_value(answers[5], 0.0);
}

// With at most N reflections the radiance is the geometric series 1 + 1/2 + … + 1/2^N.
TEST(Query, BouncesCutTheSeries) {
  const Workshop shop;
  for (int bounces = 0; bounces <= 2; ++bounces) {
    const Json answers =
        ask(shop, Json::array({floor_query("irradiance")}), {"--bounces", std::to_string(bounces)}).json()["queries"];
    expect_value(answers[0], pi * (2.0 - std::pow(0.5, bounces)));
  }
}

TEST(Query, AQueryMayCarryItsOwnBoundAndWhatItExpects) {
  const Workshop shop;
  Json bounded = floor_query("irradiance");
  bounded["bounces"] = 0, bounded["value"] = {pi, pi, pi}, bounded["abs_uncertainty"] = 0.0;
  const Json answers = ask(shop, {bounded, floor_query("irradiance")}).json()["queries"];
  expect_value(answers[0], pi);
  expect_value(answers[1], 2.0 * pi);
}

TEST(Query, AMethodWithoutVarianceSaysNull) {
  const Workshop shop;
  shop.write("points.json", Json{{"queries", Json::array({floor_query("irradiance")})}});
  const Json answers =
      shop.gibench({"query", "furnace.scene.json", "--method", "meshless", "--set", "levels=3", "--points", "points.json"})
          .json()["queries"];
  EXPECT_TRUE(answers[0]["standard_error"].is_null());
  expect_value(answers[0], 2.0 * pi);
}

TEST(Query, NoQueriesGiveNoAnswers) { EXPECT_EQ(ask(Workshop(), Json::array()).json()["queries"], Json::array()); }

TEST(Query, WrongQueriesAreToldWithTheirPlace) {
  const Workshop shop;
  const auto wrong = [&](const char* key, const Json& value) {
    Json query = floor_query("irradiance");
    query[key] = value;
    return ask(shop, {floor_query("irradiance"), query});
  };
  expect_bad_input(wrong("point", {0.4, 0.0}), {"points.json: $.queries[1].point", "[x, y, z]"});
  expect_bad_input(wrong("point", {0.4, "low", 0.3}), {"$.queries[1].point[1]"});
  expect_bad_input(wrong("point", {0.4, 0.2, 0.3}), {"$.queries[1]", "no surface"});
  expect_bad_input(wrong("normal", {0, 2, 0}), {"$.queries[1].normal", "length"});
  expect_bad_input(wrong("normal", {0.8, 0, 0.6}), {"$.queries[1]", "no surface"});
  expect_bad_input(wrong("quantity", "brightness"), {"$.queries[1].quantity", "known: radiance, irradiance"});
  expect_bad_input(wrong("component", "glossy"), {"$.queries[1].component", "direct"});
  expect_bad_input(wrong("quantity", "radiance"), {"$.queries[1]", "direction"});
  expect_bad_input(wrong("direction", {0, 1, 0}), {"$.queries[1].direction"});
  expect_bad_input(wrong("colour", 1), {"$.queries[1].colour", "unknown key"});
  expect_bad_input(ask(shop, 7), {"$.queries", "list"});
  shop.write("points.json", std::string("{\"queries\": ["));
  const std::vector<std::string> call{"query", "furnace.scene.json", "--method", "pathtracer", "--points", "points.json"};
  expect_bad_input(shop.gibench(call), {"points.json"});
  std::filesystem::remove(shop / "points.json");
  expect_bad_input(shop.gibench(call), {"points.json"});
}

TEST(Query, AMethodIsAskedOnlyForWhatItAnswers) {
  const Workshop shop;
  shop.write("points.json", Json{{"queries", Json::array({floor_query("accessibility")})}});
  expect_bad_input(shop.gibench({"query", "furnace.scene.json", "--method", "meshless", "--points", "points.json"}),
                   {"$.queries[0]", "accessibility"});
}

}  // namespace
}  // namespace gibench::test
