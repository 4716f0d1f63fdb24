/// Outputs that are no plain file or folder, and disks without room.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/bench/app/small_study.h"

namespace gibench::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::string> query_to(const Workshop& shop, const std::string& out) {
  shop.write(
      "points.json",
      nlohmann::ordered_json{
          {"queries", {{{"id", "floor"}, {"point", {0.5, 0.0, 0.5}}, {"normal", {0, 1, 0}}, {"quantity", "irradiance"}}}}});
  return {"query", "room.scene.json", "--method", "pathtracer", "--set", "samples=4", "--points", "points.json", "--out", out};
}

TEST(Output, OfAQueryGoesThroughAPipe) {
  const Workshop shop;
  ASSERT_EQ(mkfifo((shop / "pipe").c_str(), 0600), 0);
  const Outcome outcome = shop.gibench(query_to(shop, "pipe"), "(timeout 60 cat pipe >received) &");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_TRUE(fs::is_fifo(shop / "pipe"));
  EXPECT_EQ(shop.gibench(query_to(shop, "file")).status, 0);
  // The reader ends when the pipe is closed, which may be a moment later.
  for (int i = 0; i < 1000 && shop.read("received") != shop.read("file"); ++i) shop.gibench({"--version"});
  EXPECT_EQ(shop.read("received"), shop.read("file"));
}

TEST(Output, OfAQueryGoesWhereALinkLeads) {
  const Workshop shop;
  fs::create_directory(shop / "kept");
  fs::create_symlink("kept/answers.json", shop / "link");
  EXPECT_EQ(shop.gibench(query_to(shop, "link")).status, 0);
  EXPECT_TRUE(fs::is_symlink(shop / "link"));
  EXPECT_EQ(shop.read_json("kept/answers.json")["queries"].size(), 1U);
}

TEST(Output, ThatIsToBeAFolderAndIsNotIsRefused) {
  const Workshop shop;
  ASSERT_EQ(mkfifo((shop / "pipe").c_str(), 0600), 0);
  shop.write("file", std::string());
  shop.write("small.study.json", small_study());
  for (const std::string out : {"pipe", "file"}) {
    expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--reference", "none", "--out", out}),
                     {out + ": is not a folder", "choose another --out"});
    expect_bad_input(shop.gibench({"reference", "room.scene.json", "--out", out, "--force"}), {out + ": is not a folder"});
    expect_bad_input(shop.gibench({"study", "small.study.json", "--out", out}), {out + ": is not a folder"});
  }
  EXPECT_TRUE(fs::is_fifo(shop / "pipe"));
  EXPECT_TRUE(fs::is_regular_file(shop / "file"));
}

/// A disk of a few kilobytes for as long as it lives.
class SmallDisk {
 public:
  explicit SmallDisk(fs::path folder) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
    mounted_ = mount("none", folder_.c_str(), "tmpfs", 0, "size=16k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool is_there() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

TEST(Output, OnAFullDiskIsFailedWork) {
  const Workshop shop;
  const SmallDisk disk(shop / "disk");
  if (!disk.is_there()) GTEST_SKIP() << "no file system can be mounted here";
  const std::vector<std::vector<std::string>> calls{
      {"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=1", "--width", "64", "--reference", "none", "--out",
       "disk/out"},
      {"reference", "room.scene.json", "--samples", "2", "--references", "disk/store"},
      {"reference", "room.scene.json", "--samples", "2", "--width", "64", "--references", "store", "--out", "disk/out"}};
  for (const std::vector<std::string>& call : calls) {
    const Outcome outcome = shop.gibench(call);
    EXPECT_EQ(outcome.status, 4) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("No space left on device"));
    EXPECT_THAT(outcome.error, HasSubstr("make room and try again"));
    fs::remove_all(shop / "disk/store");
  }
  EXPECT_TRUE(fs::is_empty(shop / "disk")) << "nothing half-written is left";
}

}  // namespace
}  // namespace gibench::test
