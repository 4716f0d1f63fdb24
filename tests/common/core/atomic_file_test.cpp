#include "common/core/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <thread>

#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;
using testing::HasSubstr;

constexpr unsigned null_device = 3, full_device = 7;  // of the memory devices, major number 1

/// A device of the test's own, so that what goes wrong destroys no device of the system; empty where none can be made. A user
/// who is not root cannot replace the system's and takes those.
fs::path device(const ScratchFolder& folder, const std::string& name, unsigned minor_number) {
  const fs::path own = folder / name;
  if (mknod(own.c_str(), S_IFCHR | 0666, makedev(1, minor_number)) == 0) {
    if (std::ofstream(own).is_open()) return own;
    return {};  // the file system takes no devices
  }
  return geteuid() == 0 ? fs::path() : fs::path("/dev") / name;
}

TEST(AtomicFile, WritesAndReplaces) {
  const ScratchFolder folder;
  for (const std::string text : {"first", "second, longer", ""}) {
    write_file_atomically(folder / "file", text);
    EXPECT_EQ(read_file(folder / "file"), text);
  }
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(AtomicFile, NamesAsLongAsTheFileSystemTakesAreWritten) {
  const ScratchFolder folder;
  write_file_atomically(folder / std::string(255, 'n'), std::string("text"));
  EXPECT_EQ(read_file(folder / std::string(255, 'n')), "text");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(AtomicFile, AFullDiskIsFailedWork) {
  const ScratchFolder folder;
  const fs::path full = device(folder, "full", full_device);
  if (full.empty()) GTEST_SKIP() << "no device can be made here";
  try {
    write_file_atomically(full, std::string("text"));
    ADD_FAILURE() << "it was written";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr(full.string() + ": cannot be written (No space left on device); make room"));
  }
  EXPECT_TRUE(fs::is_character_file(full));
}

TEST(AtomicFile, ADeviceStaysADevice) {
  const ScratchFolder folder;
  const fs::path null = device(folder, "null", null_device);
  if (null.empty()) GTEST_SKIP() << "no device can be made here";
  write_file_atomically(null, std::string("text"));
  EXPECT_TRUE(fs::is_character_file(null));
}

TEST(AtomicFile, GoesThroughAPipe) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = read_file(folder / "pipe"); });
  write_file_atomically(folder / "pipe", std::string("text"));
  if (!fs::is_fifo(folder / "pipe")) write_file_atomically(folder / "pipe", std::string());
  reader.join();
  EXPECT_EQ(received, "text");
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(AtomicFile, FollowsLinks) {
  const ScratchFolder folder;
  fs::create_directory(folder / "kept");
  fs::create_symlink("kept/file", folder / "link");
  fs::create_symlink("link", folder / "link to link");
  for (const std::string text : {"made through the link", "replaced through it"}) {
    write_file_atomically(folder / "link to link", text);
    EXPECT_EQ(read_file(folder / "kept" / "file"), text);
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link to link"));
  }
  fs::create_symlink("circle", folder / "circle");
  EXPECT_THROW(write_file_atomically(folder / "circle", std::string("text")), InputError);
}

TEST(AtomicFile, AWrongPlaceIsAWrongCall) {
  const ScratchFolder folder;
  EXPECT_THROW(write_file_atomically(folder / "nowhere" / "file", std::string("text")), InputError);
  EXPECT_THROW(write_file_atomically(folder.path(), std::string("text")), InputError);
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace gibench
