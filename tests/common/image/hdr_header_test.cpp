#include "common/image/hdr_header.h"

#include <gtest/gtest.h>

#include <string>

#include "common/core/atomic_file.h"
#include "common/image/image_file.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

/// One pixel of (1, 0.5, 0.25): mantissas 128, 64, 32 of 256, exponent 1.
std::string hdr(const std::string& facts) {
  return "#?RADIANCE\n" + facts + "FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x40\x20\x81";
}

Rgb pixel_of(const std::string& bytes) {
  const test::ScratchFolder folder;
  write_file_atomically(folder / "a.hdr", bytes);
  return read_image(folder / "a.hdr").pixels.at(0);
}

TEST(HdrHeader, TheExposureIsTakenOut) {
  const Rgb plain = pixel_of(hdr(""));
  EXPECT_NEAR(plain.r, 1.0F, 0.005F);
  EXPECT_EQ(pixel_of(hdr("EXPOSURE=2\nEXPOSURE= 4.0\n")), plain / 8.0F) << "the product of all of them";
  EXPECT_EQ(pixel_of(hdr("EXPOSURE=0\nEXPOSURE=none\n")), plain) << "what is no factor changes nothing";
}

TEST(HdrHeader, OtherPrimariesAreConverted) {
  const Chromaticities radiance{0.640F, 0.330F, 0.290F, 0.600F, 0.150F, 0.060F, 0.3333F, 0.3333F};
  const Rgb converted = pixel_of(hdr("PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.3333 0.3333\n"));
  EXPECT_EQ(converted, ColourConversion::to_rec709(radiance).value()(pixel_of(hdr(""))));
  EXPECT_EQ(pixel_of(hdr("PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329\n")), pixel_of(hdr("")));
}

TEST(HdrHeader, SizesInEitherOrder) {
  const HdrHeader rows = read_hdr_header("#?RGBE\n\n-Y 12 +X 34\n"), columns = read_hdr_header("#?RGBE\n\n+X 34 -Y 12\n");
  EXPECT_EQ(rows.height, 12.0);
  EXPECT_EQ(rows.width, 34.0);
  EXPECT_EQ(columns.height, 12.0);
  EXPECT_EQ(columns.width, 34.0);
  EXPECT_EQ(read_hdr_header("#?RGBE\n\nnothing\n").width, 0.0);
  EXPECT_EQ(read_hdr_header("").height, 0.0);
}

}  // namespace
}  // namespace gibench
