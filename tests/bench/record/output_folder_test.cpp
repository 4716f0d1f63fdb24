/// Folders are made by one process at a time, and nothing else is replaced by them.
#include "bench/record/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;
using testing::HasSubstr;

constexpr const char* marker = "marker";

void fill(const OutputFolder& folder, const std::string& text) { write_file_atomically(folder.partial() / marker, text); }

void make(const fs::path& target, const std::string& text, bool force = false) {
  OutputFolder folder(target, marker, force);
  fill(folder, text);
  folder.commit();
}

/// What the constructor says of a target.
std::string refusal(const fs::path& target, bool force) {
  try {
    const OutputFolder folder(target, marker, force);
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(OutputFolder, AppearsWholeAndLeavesNothingElse) {
  const ScratchFolder scratch;
  {
    OutputFolder folder(scratch / "out", marker, false);
    fill(folder, "first");
    EXPECT_FALSE(fs::exists(scratch / "out"));
    folder.commit();
  }
  EXPECT_EQ(read_file(scratch / "out" / marker), "first");
  EXPECT_THAT(refusal(scratch / "out", false), HasSubstr("exists already"));
  make(scratch / "out", "second", true);
  EXPECT_EQ(read_file(scratch / "out" / marker), "second");
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST(OutputFolder, IsMadeByOneAtATime) {
  const ScratchFolder scratch;
  OutputFolder first(scratch / "out", marker, true);
  fill(first, "first");
  EXPECT_THAT(refusal(scratch / "out", true), HasSubstr("out: another gibench works in this folder"));
  EXPECT_EQ(read_file(first.partial() / marker), "first") << "the refused one left it alone";
  first.commit();
}

TEST(OutputFolder, IsWaitedForWhereAsked) {
  const ScratchFolder scratch;
  std::optional<OutputFolder> first(std::in_place, scratch / "out", marker, true);
  std::atomic<bool> waits{false};
  std::thread second([&] {
    OutputFolder folder(scratch / "out", marker, true, FileLock::WhenTaken::wait, [&] { waits = true; });
    fill(folder, "second");
    folder.commit();
  });
  while (!waits) std::this_thread::yield();
  fill(*first, "first");
  first->commit();
  EXPECT_EQ(read_file(scratch / "out" / marker), "first");
  first.reset();
  second.join();
  EXPECT_EQ(read_file(scratch / "out" / marker), "second");
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST(OutputFolder, AWaitCanBeEnded) {
  const ScratchFolder scratch;
  const OutputFolder first(scratch / "out", marker, true);
  const auto stop = [] { throw WorkError("cancelled"); };
  EXPECT_THROW(OutputFolder(scratch / "out", marker, true, FileLock::WhenTaken::wait, stop), WorkError);
}

TEST(OutputFolder, ReplacesNothingThatIsNotItsOwn) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "file") << "mine";
  EXPECT_THAT(refusal(scratch / "file", true), HasSubstr("file: is not a folder"));
  EXPECT_EQ(read_file(scratch / "file"), "mine");
  fs::create_directory(scratch / "others");
  std::ofstream(scratch / "others" / "work") << "mine";
  EXPECT_THAT(refusal(scratch / "others", true), HasSubstr("was not made by gibench"));
  EXPECT_EQ(scratch.entries(), 2U);
}

TEST(OutputFolder, WhatAppearsMeanwhileIsLeftAlone) {
  const ScratchFolder scratch;
  OutputFolder folder(scratch / "out", marker, true);
  fill(folder, "first");
  fs::create_directory(scratch / "out");
  std::ofstream(scratch / "out" / "work") << "mine";
  EXPECT_THROW(folder.commit(), InputError);
  EXPECT_EQ(read_file(scratch / "out" / "work"), "mine");
}

TEST(OutputFolder, ALinkStandsForItsTarget) {
  const ScratchFolder scratch;
  fs::create_directory_symlink("kept", scratch / "link");
  for (const std::string text : {"first", "second"}) {
    make(scratch / "link", text, true);
    EXPECT_TRUE(fs::is_symlink(scratch / "link"));
    EXPECT_EQ(read_file(scratch / "kept" / marker), text);
  }
}

}  // namespace
}  // namespace gibench
