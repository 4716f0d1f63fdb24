/// Files of a study that changed since it wrote them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/record/checksums.h"
#include "bench/record/study_record.h"
#include "common/core/atomic_file.h"
#include "reports/collect/collect.h"
#include "tests/reports/fixture/study_fixture.h"
#include "tests/support/scratch_folder.h"

namespace gibench::report {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The fixture with the checksums that a study writes into its manifest.
class DamagedStudy : public testing::Test {
 protected:
  DamagedStudy() {
    gibench::test::write_study_fixture(folder_.path());
    nlohmann::ordered_json manifest = nlohmann::ordered_json::parse(read_file(folder_ / manifest_file));
    for (const char* list : {"runs", "relights"})
      for (nlohmann::ordered_json& run : manifest[list])
        if (const fs::path its = folder_.path() / run["folder"].get<std::string>(); run["status"] == "done" && fs::exists(its))
          run["files"] = to_json(checksums_of(its, {}));
    seal(manifest);
    write_file_atomically(folder_ / manifest_file, manifest.dump(2));
  }

  void change(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = read_file(folder_ / file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << text;
    write_file_atomically(folder_ / file, text.replace(at, from.size(), to));
  }

  gibench::test::ScratchFolder folder_;
};

TEST_F(DamagedStudy, ThatIsWholeIsNotSpokenOf) {
  EXPECT_THAT(collect_study(folder_.path()).warnings, testing::ElementsAre(HasSubstr("run broken: ")));
}

TEST_F(DamagedStudy, TakesAChangedRecordForAFailure) {
  change("runs/run-1-1/result.json", "\"noise_floor\": 0.004", "\"noise_floor\": 0.003");
  const Study study = collect_study(folder_.path());
  const std::string told = "runs/run-1-1/result.json: is not as it was written; run the study again: it does this again";
  EXPECT_THAT(study.warnings, Contains("run run-1-1: " + told));
  EXPECT_EQ(study.runs.at(0).status, RunStatus::failed);
  EXPECT_THAT(study.runs.at(0).message, HasSubstr(told));
  EXPECT_TRUE(study.runs.at(0).errors.empty()) << "no number of it is shown";
}

TEST_F(DamagedStudy, NamesLostFilesAndRelightings) {
  fs::remove(folder_ / "runs/run-1-2/image.exr");
  change("runs/relit-1/relight.json", "16.0", "15.0");
  const Study study = collect_study(folder_.path());
  EXPECT_THAT(study.warnings, Contains(HasSubstr("run run-1-2: runs/run-1-2/image.exr: is missing; run the study again")));
  EXPECT_EQ(study.runs.at(1).status, RunStatus::done) << "its numbers are whole";
  EXPECT_THAT(study.warnings, Contains(HasSubstr("relighting relit-1: runs/relit-1/relight.json: is not as it was written")));
  EXPECT_EQ(study.relights.at(0).status, RunStatus::failed);
  EXPECT_FALSE(study.relights.at(0).frames.has_value());
}

TEST_F(DamagedStudy, TellsOfAChangedManifest) {
  EXPECT_THAT(collect_study(folder_.path()).warnings, Not(Contains(HasSubstr("manifest.json"))));
  change("manifest.json", "\"seed\": 1", "\"seed\": 2");
  EXPECT_THAT(collect_study(folder_.path()).warnings, Contains(HasSubstr("manifest.json: is not as it was written")));
}

}  // namespace
}  // namespace gibench::report
