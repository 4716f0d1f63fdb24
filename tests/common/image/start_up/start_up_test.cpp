#include <gtest/gtest.h>

#include "common/core/atomic_file.h"
#include "common/image/image_file.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

/// Whether OpenImageIO's library is in this process.
bool openimageio_is_loaded() { return read_file("/proc/self/maps").find("libOpenImageIO") != std::string::npos; }

/// A program of its own: any other test that reads a picture would have loaded the library.
TEST(ImageStartUp, OpenImageIoIsLoadedByTheFirstPictureOnly) {
  EXPECT_FALSE(openimageio_is_loaded());
  const test::ScratchFolder folder;
  EXPECT_ANY_THROW(read_image(folder / "none.exr"));
  EXPECT_FALSE(openimageio_is_loaded()) << "a missing file is reported without it";
  write_png(folder / "a.png", {1, 1, {Rgb(0.5F)}});
  EXPECT_TRUE(openimageio_is_loaded());
}

}  // namespace
}  // namespace gibench
