#include "common/reference/reference_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/reference/folder_replacement.h"
#include "common/scene/made_scenes.h"
#include "tests/common/reference/references.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::image_question;
using test::random_reference;
using test::ScratchFolder;
using test::surface_question;
using testing::HasSubstr;

void expect_equal(const Reference& a, const Reference& b) {
  EXPECT_EQ(a.samples_per_replica, b.samples_per_replica);
  EXPECT_EQ(a.seconds, b.seconds);
  EXPECT_EQ(a.surface.direct.replicas, b.surface.direct.replicas);
  EXPECT_EQ(a.surface.indirect.replicas, b.surface.indirect.replicas);
  EXPECT_EQ(a.image.direct.replicas, b.image.direct.replicas);
  EXPECT_EQ(a.image.indirect.replicas, b.image.indirect.replicas);
}

/// What find() throws for a damaged store.
std::string finding_error(const ReferenceStore& store, const Scene& scene, const ReferenceQuestion& question) {
  try {
    store.find(scene, question);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReferenceStore, GivesBackWhatWasSaved) {
  const ScratchFolder folder;
  const ReferenceStore store(folder / "references");
  const Scene scene = made::box_scene();
  EXPECT_FALSE(store.find(scene, surface_question()));
  for (const ReferenceQuestion& question : {surface_question(), image_question()}) {
    const Reference reference = random_reference(question, 3);
    store.save(scene, reference);
    const auto found = store.find(scene, question);
    ASSERT_TRUE(found);
    expect_equal(*found, reference);
    EXPECT_EQ(found->question.path_class, question.path_class);
  }
}

TEST(ReferenceStore, MetaIsForReaders) {
  const ScratchFolder folder;
  const ReferenceStore store(folder.path());
  const Scene scene = made::box_scene();
  const Reference reference = random_reference(image_question(), 3);
  store.save(scene, reference);
  const auto meta = nlohmann::json::parse(read_file(store.folder_of(scene, image_question()) / "meta.json"));
  EXPECT_EQ(meta.at("scene"), scene.name);
  EXPECT_EQ(meta.at("path_class"), "C.*[LOB]");
  EXPECT_EQ(meta.at("samples_per_replica"), 64);
  EXPECT_EQ(meta.at("seconds"), 1.25);
  EXPECT_EQ(meta.at("camera").at("resolution"), (nlohmann::json{6, 4}));
  EXPECT_EQ(meta.at("parts").at("image_direct").at("values"), 24);
  EXPECT_NEAR(meta.at("parts").at("surface_direct").at("relative_standard_error").get<double>(),
              relative_standard_error(reference.surface.direct).value(), 1e-12);
}

TEST(ReferenceStore, ReplacesWholeAndLeavesNothingOver) {
  const ScratchFolder folder;
  const ReferenceStore store(folder.path());
  const Scene scene = made::box_scene();
  store.save(scene, random_reference(surface_question(), 3));
  const Reference second = random_reference(surface_question(), 99);
  store.save(scene, second);
  expect_equal(store.find(scene, surface_question()).value(), second);
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(ReferenceStore, AKilledWriteLeavesTheOldOne) {
  const ScratchFolder folder;
  const ReferenceStore store(folder.path());
  const Scene scene = made::box_scene();
  const Reference first = random_reference(surface_question(), 3);
  store.save(scene, first);
  // What a run killed in the middle of save() leaves: a hidden folder with some of the files, one of them cut.
  const std::filesystem::path half = temporary_beside(store.folder_of(scene, surface_question()));
  std::filesystem::create_directory(half);
  std::ofstream(half / "surface_direct.replicas") << "GIBREPL1 cut";
  expect_equal(store.find(scene, surface_question()).value(), first);
  const Reference second = random_reference(surface_question(), 4);
  store.save(scene, second);
  expect_equal(store.find(scene, surface_question()).value(), second);
}

TEST(ReferenceStore, AKillBetweenTwoRenamesLosesNothing) {
  const ScratchFolder folder;
  const ReferenceStore store(folder.path());
  const Scene scene = made::box_scene();
  const Reference first = random_reference(surface_question(), 3);
  store.save(scene, first);
  const std::filesystem::path target = store.folder_of(scene, surface_question());
  std::filesystem::rename(target, previous_version(target));  // where there is no exchange, the moment between the two
  expect_equal(store.find(scene, surface_question()).value(), first);
  const Reference second = random_reference(surface_question(), 4);
  store.save(scene, second);
  expect_equal(store.find(scene, surface_question()).value(), second);
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(ReferenceStore, DamageIsFoundAndNamed) {
  const ScratchFolder folder;
  const ReferenceStore store(folder.path());
  const Scene scene = made::box_scene();
  store.save(scene, random_reference(surface_question(), 3));
  const std::filesystem::path target = store.folder_of(scene, surface_question());
  for (const char* name : {"surface_direct.replicas", "surface_indirect.replicas", "image_direct.replicas", "meta.json"}) {
    const std::filesystem::path file = target / name;
    const std::string whole = read_file(file);
    const auto expect_damage = [&](const std::string& what) {
      const std::string error = finding_error(store, scene, surface_question());
      EXPECT_THAT(error, HasSubstr(file.string())) << what;
      EXPECT_THAT(error, HasSubstr("make it again")) << what;
    };
    for (const std::size_t place : {std::size_t{9}, whole.size() / 2, whole.size() - 3}) {
      std::string changed = whole;
      changed[place] = static_cast<char>(changed[place] ^ 1);
      write_file_atomically(file, changed);
      expect_damage("byte " + std::to_string(place));
    }
    for (const std::size_t length : {std::size_t{0}, std::size_t{12}, whole.size() - 2}) {
      write_file_atomically(file, std::span(whole.data(), length));
      expect_damage("cut to " + std::to_string(length));
    }
    std::filesystem::remove(file);
    expect_damage("missing");
    write_file_atomically(file, whole);
    EXPECT_TRUE(store.find(scene, surface_question()));
  }
}

TEST(ReferenceStore, AFileOfAnotherReferenceIsFound) {
  const ScratchFolder folder;
  const ReferenceStore store(folder / "one"), other(folder / "other");
  const Scene scene = made::box_scene();
  store.save(scene, random_reference(surface_question(), 3));
  other.save(scene, random_reference(surface_question(), 4));
  const std::filesystem::path target = store.folder_of(scene, surface_question());
  std::filesystem::copy_file(other.folder_of(scene, surface_question()) / "surface_direct.replicas",
                             target / "surface_direct.replicas", std::filesystem::copy_options::overwrite_existing);
  EXPECT_THAT(finding_error(store, scene, surface_question()), HasSubstr("not the file that meta.json names"));
  ReferenceQuestion later = surface_question();
  later.seed = 2;
  std::filesystem::copy(other.folder_of(scene, surface_question()), store.folder_of(scene, later));
  EXPECT_THAT(finding_error(store, scene, later), HasSubstr("belongs to another folder"));
}

TEST(ReferenceStore, AValueThatIsNotFiniteIsFound) {
  const ScratchFolder folder;
  const ReferenceStore store(folder.path());
  const Scene scene = made::box_scene();
  Reference reference = random_reference(surface_question(), 3);
  reference.surface.indirect.replicas[5][2].g = std::numeric_limits<float>::quiet_NaN();
  store.save(scene, reference);
  EXPECT_THAT(finding_error(store, scene, surface_question()), HasSubstr("not finite"));
}

TEST(ReferenceStore, AnUnwritableStoreIsNamed) {
  const ScratchFolder folder;
  std::ofstream(folder / "file") << "in the way";
  const ReferenceStore store(folder / "file" / "references");
  EXPECT_THROW(store.save(made::box_scene(), random_reference(surface_question(), 3)), InputError);
  EXPECT_EQ(folder.entries(), 1U);
}

}  // namespace
}  // namespace gibench
