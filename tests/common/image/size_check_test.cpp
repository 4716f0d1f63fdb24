#include "common/image/size_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/core/atomic_file.h"
#include "common/image/image_file.h"
#include "tests/common/image/reading_error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::ScratchFolder;
using testing::HasSubstr;

constexpr const char* problem = "more pixels than a file of its length can hold";

std::string png_header(const std::string& width, const std::string& height) {
  return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + width + height + std::string("\x08\x06\0\0\0", 5);
}

TEST(SizeCheck, APngHoldsAThousandBytesInOne) {
  const std::string one("\0\0\x01\0", 4), large("\0\1\0\0", 4);  // 256 and 65536
  EXPECT_EQ(size_damage(png_header(one, one) + std::string(300, 'x'), "png"), "");
  EXPECT_THAT(size_damage(png_header(large, large) + std::string(300, 'x'), "png"), HasSubstr(problem));
}

TEST(SizeCheck, AnHdrHoldsRunsOf127) {
  const auto header = [](const char* size) { return std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + size + "\n"; };
  EXPECT_EQ(size_damage(header("-Y 10 +X 127") + std::string(120, '\1'), "hdr"), "");
  EXPECT_THAT(size_damage(header("-Y 10 +X 1270") + std::string(120, '\1'), "hdr"), HasSubstr(problem));
  EXPECT_THAT(size_damage(header("-Y 1000000 +X 1000000") + std::string(120, '\1'), "hdr"), HasSubstr(problem));
  EXPECT_THAT(size_damage(header("+X 1000000 -Y 4") + std::string(120, '\1'), "hdr"), HasSubstr(problem));
}

TEST(SizeCheck, PnmPixelsHaveTheirBytes) {
  EXPECT_EQ(size_damage("PF\n2 1\n-1.0\n" + std::string(24, '\0'), "pnm"), "");
  EXPECT_THAT(size_damage("PF\n20000 20000\n-1.0\n" + std::string(24, '\0'), "pnm"), HasSubstr(problem));
  EXPECT_THAT(size_damage("P6\n# made up\n20000 20000\n255\nxx", "pnm"), HasSubstr(problem));
  EXPECT_EQ(size_damage("P6\n# 20000 20000\n1 1\n255\nxxx", "pnm"), "") << "a comment states nothing";
  EXPECT_THAT(size_damage("P3\n2000 2000\n255\n1 1 1", "pnm"), HasSubstr(problem));
}

TEST(SizeCheck, AJpegBlockTakesABit) {
  const auto jpeg = [](const std::string& size) {
    return std::string("\xff\xd8\xff\xe0\0\x04xx\xff\xc0\0\x11\x08", 13) + size + std::string(100, '\0');
  };
  EXPECT_EQ(size_damage(jpeg(std::string("\0\x40\0\x40", 4)), "jpeg"), "");
  EXPECT_THAT(size_damage(jpeg("\x4e\x20\x4e\x20"), "jpeg"), HasSubstr(problem));
}

TEST(SizeCheck, IsAskedBeforeAPictureIsDecoded) {
  const ScratchFolder folder;
  write_file_atomically(folder / "a.pfm", std::string("PF\n11000 11000\n-1.0\n") + std::string(24, '\0'));
  EXPECT_THAT(test::reading_error(folder / "a.pfm"), HasSubstr(problem));
}

}  // namespace
}  // namespace gibench
