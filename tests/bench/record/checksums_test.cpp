#include "bench/record/checksums.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/record/process_record.h"
#include "bench/record/reference_record.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

TEST(Checksums, TellEveryKindOfDamage) {
  const ScratchFolder folder;
  const std::string text = "numbers: 0.25";
  for (const char* name : {"cut", "emptied", "flipped", "folder", "gone", "log", "whole"})
    write_file_atomically(folder / name, text);
  const FileChecksums files = checksums_of(folder.path(), {"log"});
  EXPECT_EQ(files.size(), 6U);
  EXPECT_TRUE(damaged_files(folder.path(), files).empty());
  fs::resize_file(folder / "cut", text.size() / 2);
  fs::resize_file(folder / "emptied", 0);
  write_file_atomically(folder / "flipped", std::string("numbers: 0.35"));
  write_file_atomically(folder / "log", std::string("annotated"));
  fs::remove(folder / "folder"), fs::create_directory(folder / "folder");
  fs::remove(folder / "gone");
  std::vector<std::string> told;
  for (const DamagedFile& file : damaged_files(folder.path(), files)) told.push_back(file.name + " " + file.problem);
  EXPECT_THAT(told, testing::ElementsAre("cut is not as it was written", "emptied is not as it was written",
                                         "flipped is not as it was written", "folder is not a file", "gone is missing"));
}

TEST(Checksums, OfFilesAreReadAsTheyWereWritten) {
  const FileChecksums files{{"a", "1"}, {"b", "2"}};
  EXPECT_EQ(file_checksums_of(to_json(files)), files);
  EXPECT_THROW(file_checksums_of({{"../a", "1"}}), InputError) << "it leads out of the folder";
}

TEST(Seal, BreaksWithAnyChange) {
  nlohmann::ordered_json record{{"value", 0.1}, {"list", {1, 2}}, {"name", "a"}};
  EXPECT_EQ(seal_of(record), Seal::none);
  seal(record);
  EXPECT_EQ(seal_of(nlohmann::ordered_json::parse(record.dump(2))), Seal::fits) << "as it is read from a file";
  record["value"] = 0.2;
  EXPECT_EQ(seal_of(record), Seal::broken);
}

/// The text with one number changed in it, as a stray edit or a bad sector does.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << text;
  return text.replace(at, from.size(), to);
}

TEST(Seal, AChangedRunRecordIsNone) {
  const ScratchFolder folder;
  ProcessRecord record;
  record.key = "k", record.status = RunStatus::done, record.wall_seconds = 0.5;
  record.reference = "key:128", record.path_reference = "other:64", record.files = {{"result.json", "00ff"}};
  const std::string text = to_json(record).dump(2);
  write_file_atomically(folder / process_file, text);
  const auto read = read_process_record(folder / process_file);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->files, record.files);
  EXPECT_EQ(read->reference, record.reference);
  EXPECT_EQ(read->path_reference, record.path_reference);
  for (const auto& [from, to] : {std::pair("0.5", "0.6"), std::pair("00ff", "00fe"), std::pair("\"done\"", "\"failed\"")}) {
    write_file_atomically(folder / process_file, changed(text, from, to));
    EXPECT_FALSE(read_process_record(folder / process_file).has_value()) << to;
  }
}

TEST(Seal, AChangedReferenceRecordIsTold) {
  const ScratchFolder folder;
  ReferenceRecord record;
  record.facts.key = "k", record.facts.samples_per_replica = 16, record.facts.replicas = 8;
  record.files = {{"reference.exr", "00ff"}};
  const std::string text = to_json(record).dump(2);
  write_file_atomically(folder / reference_file, text);
  EXPECT_EQ(read_reference_record(folder / reference_file).files, record.files);
  write_file_atomically(folder / reference_file, changed(text, "\"samples_per_replica\": 16", "\"samples_per_replica\": 17"));
  EXPECT_THROW(read_reference_record(folder / reference_file), InputError);
}

}  // namespace
}  // namespace gibench
