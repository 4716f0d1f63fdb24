#include "reports/tables/pair_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bench/record/checksums.h"
#include "bench/record/pair_record.h"
#include "common/core/atomic_file.h"
#include "reports/collect/compare_runs.h"
#include "reports/tables/standing.h"
#include "reports/tables/study_tables.h"
#include "tests/support/scratch_folder.h"

namespace gibench::report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const ErrorKey key{Domain::surface, Component::indirect, "relative_rmse"};

/// Terms of an error whose square is `square` on the whole, with a spread over points that all runs share, and one of its own.
PairTerms terms_of(double square, double own_spread, std::uint64_t phase) {
  PairTerms terms;
  terms.value = square;
  for (int k = 0; k < 8; ++k) terms.influences.push_back(1e-4 * std::cos(2.1 * k));
  for (int i = 0; i < 200; ++i) {
    const double shared = std::sin(0.7 * i), own = std::sin(1.3 * i + static_cast<double>(phase));
    terms.parts.push_back(static_cast<float>(square + 0.05 * shared + own_spread * own));
  }
  terms.seeds = {square};
  terms.mean = 1.0;
  return terms;
}

/// A study of one scene whose runs have these errors, and the files of their terms.
class Pairs : public testing::Test {
 protected:
  Pairs() { study_.scenes.emplace_back().name = "box"; }

  StudyRun& add(const std::string& label, double error, double own_spread, const std::string& reference = "key") {
    StudyRun& run = study_.runs.emplace_back();
    run.id = run.label = label, run.scene = "box", run.method = "m", run.status = RunStatus::done;
    run.folder = folder_ / label;
    run.seconds[Stage::shade_surface] = 1.0;
    run.errors[key] = {.value = error, .low = 0.5 * error, .high = 1.5 * error, .noise_floor = {}};
    PairRecord record{reference, 64, 8, {}};
    record.errors[key.component][key.domain]["rmse"] = terms_of(error * error, own_spread, study_.runs.size());
    const std::string bytes = to_cbor(record);
    std::filesystem::create_directories(run.folder);
    write_file_atomically(run.folder / pair_file, bytes);
    run.pair_checksum = checksum_of(bytes);
    return run;
  }
  void compare() {
    compare_runs(study_, [] {});
  }
  std::string standing(std::size_t run) { return standing_text(metric_info(key.metric), standings(study_, 0, key).at(run)); }

  gibench::test::ScratchFolder folder_;
  Study study_;
};

/// The intervals of the errors themselves overlap: what both runs share hides the difference.
TEST_F(Pairs, AreToldApartByTheIntervalOfTheirDifference) {
  add("fine", 0.10, 0.0), add("coarse", 0.11, 0.0), add("noisy", 0.105, 0.1);
  compare();
  const auto apart = study_.scenes[0].comparison(key, 0, 1);
  ASSERT_TRUE(apart);
  EXPECT_NEAR(apart->difference, -0.01, 1e-6);
  EXPECT_LT(apart->high, 0.0);
  EXPECT_FALSE(study_.scenes[0].comparison(key, 0, 2)->told_apart());
  const auto back = study_.scenes[0].comparison(key, 1, 0);
  EXPECT_EQ(back->difference, -apart->difference);
  EXPECT_EQ(back->low, -apart->high);
  EXPECT_EQ(standing(0), "best");
  EXPECT_THAT(standing(1), StartsWith("worse by 1.00 % ["));
  EXPECT_THAT(standing(2), StartsWith("not told apart ["));
  const Table pairs = pair_table(study_, 0, key);
  ASSERT_EQ(pairs.rows.size(), 3U);
  EXPECT_EQ(pairs.rows[1].back().text, "fine");
  EXPECT_EQ(pairs.rows[0].back().text, "–") << "of the noisy one nothing is known";
  const std::string csv = to_csv(scene_table(study_, 0, key));
  EXPECT_THAT(csv, HasSubstr("beside_best,beside_best_ci95_low,beside_best_ci95_high,beside_best_told_apart"));
  EXPECT_THAT(to_markdown(scene_table(study_, 0, key)), HasSubstr("Beside the best"));
}

/// The smallest estimate of an error that may be large is not the best one.
TEST_F(Pairs, TheBestIsChosenByTheErrorThatIsShown) {
  add("known", 0.10, 0.0);
  MeasuredError& unknown = add("unknown", 0.05, 0.5).errors[key];
  unknown.low = 0.0, unknown.high = 0.3, unknown.resolved = false;
  compare();
  EXPECT_EQ(standing(0), "best");
  EXPECT_THAT(standing(1), StartsWith("not told apart ["));
}

TEST_F(Pairs, OfOtherReferencesAreNotCompared) {
  add("one", 0.1, 0.0), add("two", 0.2, 0.0, "another key");
  compare();
  EXPECT_TRUE(study_.scenes[0].comparisons.empty());
  EXPECT_THAT(pair_table(study_, 0, key).rows, IsEmpty());
  EXPECT_EQ(to_csv(scene_table(study_, 0, key)).find("beside_best"), std::string::npos);
}

TEST_F(Pairs, ADamagedFileIsToldAndLeftOut) {
  add("one", 0.1, 0.0), add("two", 0.2, 0.0), add("three", 0.3, 0.0);
  write_file_atomically(study_.runs[1].folder / pair_file, "not as it was");
  compare();
  ASSERT_EQ(study_.warnings.size(), 1U);
  EXPECT_THAT(study_.warnings[0], HasSubstr("run two is not compared with others"));
  EXPECT_EQ(pair_table(study_, 0, key).rows.size(), 1U);
}

TEST_F(Pairs, TheMostAccurateRunsAreCompared) {
  for (std::size_t i = 0; i < most_compared_runs + 5; ++i) add(std::to_string(i), 0.5 - 0.01 * static_cast<double>(i), 0.0);
  compare();
  const auto compared = standings(study_, 0, key);
  EXPECT_EQ(compared.size(), most_compared_runs);
  EXPECT_FALSE(compared.contains(0)) << "the largest error";
  EXPECT_TRUE(compared.at(most_compared_runs + 4).is_best);
}

}  // namespace
}  // namespace gibench::report
