/// The references in scenes/references against fresh replicates, which no stored one has a random number in common with.
#include "bench/measure/reference_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench/measure/reference_making.h"
#include "bench/record/reference_facts.h"
#include "common/core/atomic_file.h"
#include "common/reference/scene_key.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path shipped = fs::path(GIBENCH_SOURCE_DIR) / "scenes" / "references";

std::vector<fs::path> reference_folders() {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(shipped))
    if (fs::exists(entry.path() / "meta.json")) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

MeasuringOptions options_of(const Json& meta) {
  MeasuringOptions options;
  options.surface_samples = meta.at("surface_samples").get<std::size_t>();
  options.surface_domain = meta.at("surface_domain").get<std::string>();
  options.pixel_samples = meta.at("pixel_samples").get<int>();
  options.reference_seed = meta.at("seed").get<std::uint64_t>();
  options.camera = meta.at("camera").at("name").get<std::string>();
  options.image_width = meta.at("camera").at("resolution").at(0).get<int>();
  if (meta.at("path_class") != path_class({})) options.light_paths = meta.at("path_class").get<std::string>();
  return options;
}

using Values = std::vector<Rgb>;

/// A sum of terms that are independent of one another and have the mean 0, over the root of the sum of their squares: nearly
/// normal.
class Score {
 public:
  void add(double term) {
    sum_ += term;
    squares_ += term * term;
  }
  double value() const { return squares_ > 0.0 ? sum_ / std::sqrt(squares_) : 0.0; }

 private:
  double sum_ = 0.0, squares_ = 0.0;
};

struct Scores {
  Score product, difference;
};

/// With R_A, R_B the halves of the stored replicates and F_A, F_B two thirds of the fresh ones, the term of a value is
/// w (F_A − R_A)(F_B − R_B): all four are independent, so that it has the mean (f − r)² w, which is 0 where both are of the same
/// light, and its terms are independent from value to value, as every value has paths of its own. w = 1/(F_C² + M²) with
/// the last third F_C, independent of the four, and M its mean, keeps bright values from deciding alone. The difference
/// w½ (F_A + F_B − R_A − R_B) shows what is only a little too bright everywhere. `shift` compares with the value so many places
/// on: other light.
Scores scores_of(const Replicas& stored, const Replicas& fresh, std::size_t shift) {
  const Values ra = stored.half(0), rb = stored.half(1), fa = fresh.every(3, 0), fb = fresh.every(3, 1), fc = fresh.every(3, 2);
  double mean = 0.0;
  for (const Rgb& value : fc) mean += (value.r + value.g + value.b) / (3.0 * static_cast<double>(fc.size()));
  Scores scores;
  for (std::size_t i = 0; i < fa.size(); ++i) {
    const std::size_t other = (i + shift) % fa.size();
    double product = 0.0, difference = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double a = static_cast<double>(fa[i][c]) - ra[other][c], b = static_cast<double>(fb[i][c]) - rb[other][c];
      const double weight = 1.0 / (static_cast<double>(fc[i][c]) * fc[i][c] + mean * mean + 1e-30);
      product += weight * a * b;
      difference += std::sqrt(weight) * (a + b);
    }
    scores.product.add(product);
    scores.difference.add(difference);
  }
  return scores;
}

/// |z| > 5 has a chance of 6e-7 in a normal distribution; there are fewer than a hundred scores.
constexpr double most = 5.0;

class ShippedReference : public testing::TestWithParam<fs::path> {};

TEST_P(ShippedReference, AgreesWithFreshReplicates) {
  const Json meta = Json::parse(read_file(GetParam() / "meta.json"));
  const LoadedScene scene = load_world(meta.at("scene").get<std::string>(), 0);
  const MeasuringOptions options = options_of(meta);
  const ReferenceQuestion question = question_of(scene.scene(), options);
  ASSERT_EQ(reference_key(scene.scene(), question), GetParam().filename().string())
      << "the scene or the question has changed: make it anew with scenes/references/make.sh";
  const auto stored = ReferenceStore(shipped).find(scene.scene(), question);
  ASSERT_TRUE(stored);
  // Packing makes the target of 0.005 (of some of the light paths 0.01) larger by a seventh at most: √(1 + 1/3) of each
  // replicate.
  const double target = options.light_paths.empty() ? 0.005 : 0.01;
  EXPECT_LE(facts_of(scene.scene(), *stored).surface_error.value_or(0.0), 1.16 * target);

  Reference fresh;
  fresh.question = question;
  ReplicaSet others;
  others.first = 1000;
  WorkOptions work;
  work.quiet = true;
  extend_reference(scene, options, others, {64, 4, std::nullopt}, work, fresh, [](const Reference&) {});
  ASSERT_EQ(fresh.points, stored->points) << "the surface samples have changed: make it anew with scenes/references/make.sh";
  for (const auto values : {&Reference::surface, &Reference::image})
    for (const auto component : {&ReferenceValues::direct, &ReferenceValues::indirect}) {
      const Scores same = scores_of((*stored).*values.*component, fresh.*values.*component, 0);
      EXPECT_LT(std::abs(same.product.value()), most);
      EXPECT_LT(std::abs(same.difference.value()), most);
    }
  const Scores other = scores_of(stored->surface.indirect, fresh.surface.indirect, 1);
  EXPECT_GT(other.product.value(), most) << "the test would not see light of other points";
}

std::string name_of(const testing::TestParamInfo<fs::path>& folder) {
  std::string name = Json::parse(read_file(folder.param / "meta.json")).at("scene").get<std::string>();
  std::replace(name.begin(), name.end(), '-', '_');
  return name + "_" + folder.param.filename().string().substr(0, 8);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ShippedReference);
INSTANTIATE_TEST_SUITE_P(All, ShippedReference, testing::ValuesIn(reference_folders()), name_of);

TEST(ShippedReferences, AreAFewMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(shipped))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LT(bytes, 6'000'000U);
}

TEST(ShippedReferences, AreElsewhereOrNowhereWhereTheEnvironmentSaysSo) {
  ::setenv("GIBENCH_REFERENCES", "", 1);
  EXPECT_FALSE(shipped_references());
  ::setenv("GIBENCH_REFERENCES", "/elsewhere", 1);
  EXPECT_TRUE(shipped_references());
  ::unsetenv("GIBENCH_REFERENCES");
  EXPECT_TRUE(shipped_references());
}

/// As on a machine whose arithmetic gives other surface samples.
TEST(ReferenceSearch, LeavesOutWhatWasTakenAtOtherSurfaceSamples) {
  const test::ScratchFolder folder;
  const LoadedScene scene = load_world("furnace-cube", 1);
  MeasuringOptions options;
  options.surface_samples = 16, options.pictures = false;
  Reference reference;
  reference.question = question_of(scene.scene(), options);
  reference.samples_per_replica = 4;
  reference.surface.direct.replicas.assign(8, Values(16, Rgb(1.0F)));
  reference.surface.indirect = reference.surface.direct;
  ::setenv("GIBENCH_REFERENCES", (folder / "shipped").c_str(), 1);
  std::vector<std::string> warnings;
  const ReferenceSearch search(folder / "own", ReferenceSearch::Stores::own_then_shipped, scene, 1,
                               [&](const std::string& line) { warnings.push_back(line); });
  reference.points = fingerprint_of(measuring_points(*scene.world, reference.question, 1).surface);
  ReferenceStore(folder / "shipped").save(scene.scene(), reference, ReferenceStore::Keep::packed);
  EXPECT_TRUE(search.find(reference.question));
  EXPECT_TRUE(warnings.empty());
  reference.points += 2;
  ReferenceStore(folder / "shipped").save(scene.scene(), reference, ReferenceStore::Keep::packed);
  EXPECT_FALSE(search.find(reference.question));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], testing::HasSubstr("fall on other faces"));
  ::unsetenv("GIBENCH_REFERENCES");
}

TEST(FingerprintOf, TellsSamplesOnOtherFacesApart) {
  SurfaceSample first, second;
  second.face = 1;
  EXPECT_EQ(fingerprint_of({first, second}), fingerprint_of({first, second}));
  EXPECT_NE(fingerprint_of({first, second}), fingerprint_of({second, first}));
  EXPECT_NE(fingerprint_of({}), 0U);
}

}  // namespace
}  // namespace gibench
