/// What a study does about files of its own that were damaged, lost or outgrown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/bench/app/small_study.h"

namespace gibench::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;

const std::string damaged_run = "room.pathtracer-samples=1", other = "room.pathtracer-samples=4";

std::string file_of(const std::string& run, const std::string& name) { return "out/runs/" + run + "/" + name; }

std::string cut_in_half(const std::string& text) { return text.substr(0, text.size() / 2); }

void flip_bit(const fs::path& file) {
  std::string bytes;
  {
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  ASSERT_GT(bytes.size(), 100U);
  bytes[bytes.size() - 3] = static_cast<char>(bytes[bytes.size() - 3] ^ 1);
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string stored_reference(const Workshop& shop) {
  return "out/references/store/" + shop.read_json("out/references/room/reference.json")["key"].get<std::string>();
}

/// A finished small study.
class StudyDamage : public testing::Test {
 protected:
  StudyDamage() {
    EXPECT_EQ(study(shop_, small_study()).status, 0);
    answers_ = answers_in(shop_, "out");
    EXPECT_EQ(answers_.size(), 2U);
    record_ = shop_.read(file_of(damaged_run, "result.json")), other_record_ = shop_.read(file_of(other, "result.json"));
  }

  /// The study ends well, the first run is there again, and the other is as it was.
  void expect_mended(const Outcome& outcome, const std::string& what) const {
    EXPECT_EQ(outcome.status, 0) << what << outcome.error;
    EXPECT_EQ(answers_in(shop_, "out"), answers_) << what;
    EXPECT_TRUE(shop_.has(file_of(damaged_run, "image.exr"))) << what;
    EXPECT_EQ(shop_.read(file_of(other, "result.json")), other_record_) << what << ": it was whole";
  }

  Workshop shop_;
  Json answers_;
  std::string record_, other_record_;
};

TEST_F(StudyDamage, OfAResultMakesItAgain) {
  for (const char* name : {"result.json", "image.exr", "run.json"}) {
    const std::string file = file_of(damaged_run, name), whole = shop_.read(file);
    for (const std::string& text : {cut_in_half(whole), std::string()}) {
      shop_.write(file, text);
      const Outcome outcome = study(shop_, small_study());
      expect_mended(outcome, name);
      EXPECT_THAT(outcome.error, HasSubstr(file)) << "the damage is named";
    }
    fs::remove(shop_ / file);
    expect_mended(study(shop_, small_study()), name);
  }
}

TEST_F(StudyDamage, OfANumberIsSeenByStudyAndReport) {
  Json changed = Json::parse(record_);
  changed["errors"]["indirect"]["surface"]["relative_rmse"]["value"] = 0.987654;
  shop_.write(file_of(damaged_run, "result.json"), changed.dump(2) + "\n");
  const std::string told = "runs/" + damaged_run + "/result.json: is not as it was written; run the study again";
  const Outcome report = shop_.gibench({"report", "out"});
  EXPECT_EQ(report.status, 0) << report.error;
  EXPECT_THAT(report.error, HasSubstr(told));
  EXPECT_THAT(shop_.read("out/report/tables/errors.csv"), Not(HasSubstr("0.987654")));
  expect_mended(study(shop_, small_study()), "a changed number");
  EXPECT_THAT(shop_.gibench({"report", "out"}).error, Not(HasSubstr("as it was written")));
}

TEST_F(StudyDamage, OfAPictureIsSeenByTheReport) {
  fs::remove(shop_ / file_of(damaged_run, "image.exr"));
  EXPECT_THAT(shop_.gibench({"report", "out"}).error,
              HasSubstr("run " + damaged_run + ": runs/" + damaged_run + "/image.exr: is missing; run the study again"));
}

TEST_F(StudyDamage, OfAReferenceCostsNoResult) {
  const std::string store = stored_reference(shop_);
  for (const std::string& name : {std::string("surface_direct.replicas"), std::string("meta.json")}) {
    flip_bit(shop_ / (store + "/" + name));
    const Outcome outcome = study(shop_, small_study());
    expect_mended(outcome, name);
    EXPECT_THAT(outcome.error, HasSubstr("room: made anew: " + store + "/" + name + ": the stored reference is damaged"));
    EXPECT_EQ(shop_.read(file_of(damaged_run, "result.json")), record_) << "no run is done again";
  }
  fs::remove(shop_ / (store + "/meta.json"));
  expect_mended(study(shop_, small_study()), "no meta.json");
  EXPECT_EQ(shop_.read(file_of(damaged_run, "result.json")), record_);
}

TEST_F(StudyDamage, OfTheWrittenReferenceIsMendedFromTheStore) {
  const std::string whole = shop_.read("out/references/room/reference.json");
  fs::remove(shop_ / "out/references/room/reference.json");
  for (int i = 0; i < 2; ++i) {  // missing, then cut short
    const Outcome outcome = study(shop_, small_study());
    expect_mended(outcome, "reference.json");
    EXPECT_EQ(shop_.read("out/references/room/reference.json"), whole);
    EXPECT_EQ(shop_.read(file_of(damaged_run, "result.json")), record_);
    shop_.write("out/references/room/reference.json", cut_in_half(whole));
  }
}

/// A reference that cannot be made again: it is told, and the results that were held against it stay.
TEST_F(StudyDamage, OfAReferenceThatCannotBeMadeAgainIsTold) {
  flip_bit(shop_ / (stored_reference(shop_) + "/surface_direct.replicas"));
  Json json = small_study({1, 2, 4});
  json["reference"]["samples"] = 1000000, json["reference"]["time_limit_seconds"] = 0.3;
  const Outcome outcome = study(shop_, json);
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, HasSubstr("gibench: small: not done: room: no reference: stopped at its time limit"));
  EXPECT_EQ(shop_.read(file_of(damaged_run, "result.json")), record_);
  const Json manifest = shop_.read_json("out/manifest.json");
  EXPECT_EQ(run_of(manifest, damaged_run)["status"], "done");
  EXPECT_THAT(manifest["scenes"][0]["message"].get<std::string>(), HasSubstr("no reference"));
  EXPECT_FALSE(shop_.read_json(file_of("room.pathtracer-samples=2", "result.json")).contains("errors"))
      << "there was nothing to hold it against";
}

/// Stopped on the way, a reference is in a state of its own each time: no run is held against that.
TEST(StudyReference, ThatIsNotWholeGivesNoErrors) {
  const Workshop shop;
  Json json = small_study();
  json["reference"] = {{"samples", 1000000}, {"time_limit_seconds", 1.5}};
  for (const std::vector<int>& samples : {std::vector<int>{1}, std::vector<int>{1, 2}}) {
    json["methods"][0]["sweep"]["samples"] = samples;
    EXPECT_EQ(study(shop, json).status, 4);
    const Json manifest = shop.read_json("out/manifest.json");
    EXPECT_EQ(manifest["runs"].size(), samples.size());
    for (const Json& run : manifest["runs"]) {
      EXPECT_EQ(run["status"], "done");
      EXPECT_FALSE(shop.read_json("out/" + run["folder"].get<std::string>() + "/result.json").contains("errors")) << run;
    }
  }
}

/// The reference of a method's own light paths is part of what its errors are.
TEST(StudyReference, OfTheLightPathsCountsAsWell) {
  const Workshop shop;
  Json glossy = room_scene();
  glossy["materials"]["wall"] = {{"bsdf", "phong"}, {"diffuse", 0.4}, {"specular", 0.3}, {"exponent", 8}};
  shop.write("room.scene.json", glossy);
  Json json = small_study({1});
  json["methods"] = {{{"method", "meshless"}, {"parameters", {{"levels", 2}, {"coarsest_samples", 50}}}}};
  ASSERT_EQ(study(shop, json).status, 0);
  const Json run = shop.read_json("out/manifest.json")["runs"][0];
  ASSERT_EQ(run["status"], "done");
  ASSERT_TRUE(run.contains("path_reference")) << "the method has not all paths of the room";
  const Json split = shop.read_json(file_of("room.meshless", "result.json"))["error_split"]["reference"];
  EXPECT_EQ(run["path_reference"], split["key"].get<std::string>() + ":" + split["samples"].dump());
}

TEST(StudyLabels, TooLongForAFileAreToldBeforeAnythingRuns) {
  const Workshop shop;
  const auto with_label = [&](std::size_t bytes) {
    Json json = small_study();
    json.erase("reference");
    json["methods"] = {{{"method", "pathtracer"}, {"label", std::string(bytes, 'M')}, {"parameters", {{"samples", 1}}}}};
    return json;
  };
  expect_bad_input(study(shop, with_label(300)), {"small.study.json: $.methods[0].label", "305 bytes", "shorten it"});
  EXPECT_FALSE(shop.has("out"));
  expect_bad_input(study(shop, with_label(219), {"--dry-run"}), {"$.methods[0].label", "224 bytes", "223 is the most"});
  const Outcome longest = study(shop, with_label(218));
  EXPECT_EQ(longest.status, 0) << longest.error;

  Json relit = small_study({1});
  relit["relights"] = {{{"scene", "room"}, {"lights", "path.json"}, {"method", "spectral"}, {"label", std::string(300, 'R')}}};
  shop.write("path.json", Json{{"gibench_light_path", 1}});
  expect_bad_input(study(shop, relit), {"$.relights[0].label"});

  Json far = small_study({1});
  const std::string long_name(230, 'L');
  shop.write(long_name + ".scene.json", room_scene());
  far["scenes"].push_back(long_name + ".scene.json");
  expect_bad_input(study(shop, far), {"$.methods[0].sweep", "LLLL"});
}

}  // namespace
}  // namespace gibench::test
