#include "bench/app/run_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "bench/measure/cancellation.h"
#include "common/core/error.h"
#include "tests/reports/fixture/study_fixture.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReportVerb : public testing::Test {
 protected:
  ReportVerb() { test::write_study_fixture(folder_ / "study"); }
  ~ReportVerb() override { setenv("PATH", path_.c_str(), 1); }

  std::string path_ = std::getenv("PATH");
  test::ScratchFolder scratch_;
  const fs::path& folder_ = scratch_.path();
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(ReportVerb, WritesPageTablesAndDataWithoutNode) {
  setenv("PATH", (folder_ / "empty").c_str(), 1);
  const fs::path report = run_report(folder_ / "study", {}, true);
  EXPECT_EQ(report, folder_ / "study" / "report");
  EXPECT_THAT(text_of(report / "index.html"), HasSubstr("<title>Fixture &lt;study&gt; &amp; more"));
  for (const std::string name : {"ranking", "runs", "errors", "effects", "failures", "scene-1-cornell-box"})
    for (const std::string ending : {".csv", ".md", ".tex"}) EXPECT_TRUE(fs::exists(report / "tables" / (name + ending))) << name;
  EXPECT_TRUE(fs::exists(report / "data" / "study.js"));
  EXPECT_FALSE(fs::exists(report / "plots" / "ranking.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "study" / "report.partial"));
}

TEST_F(ReportVerb, StopsWhenAskedAndLeavesNothing) {
  *cancellation() = true;
  EXPECT_THROW(run_report(folder_ / "study", {}, true), WorkError);
  *cancellation() = false;
  EXPECT_FALSE(fs::exists(folder_ / "study" / "report"));
  EXPECT_FALSE(fs::exists(folder_ / "study" / "report.partial"));
}

TEST_F(ReportVerb, ReplacesItsOwnReportAndNothingElse) {
  setenv("PATH", (folder_ / "empty").c_str(), 1);
  const fs::path out = folder_ / "out";
  run_report(folder_ / "study", out, true);
  std::ofstream(out / "left-over") << "old";
  run_report(folder_ / "study", out, true);
  EXPECT_FALSE(fs::exists(out / "left-over"));

  fs::create_directories(folder_ / "mine");
  std::ofstream(folder_ / "mine" / "work") << "precious";
  EXPECT_THROW(run_report(folder_ / "study", folder_ / "mine", true), InputError);
  EXPECT_EQ(text_of(folder_ / "mine" / "work"), "precious");
}

TEST_F(ReportVerb, RefusesWhatIsNoStudyAndLeavesNothing) {
  EXPECT_THROW(run_report(folder_, folder_ / "out", true), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(ReportVerb, DamagedPictureIsLeftOut) {
  setenv("PATH", (folder_ / "empty").c_str(), 1);
  fs::resize_file(folder_ / "study" / "runs" / "run-1-1" / "image.exr", 200);
  const fs::path report = run_report(folder_ / "study", {}, true);
  EXPECT_THAT(text_of(report / "data" / "study.js"), HasSubstr("runs/run-1-1/image.exr"));
}

}  // namespace
}  // namespace gibench
