/// PNG files of kinds that gibench does not write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/core/atomic_file.h"
#include "common/image/decoded_image.h"
#include "common/image/image_file.h"
#include "common/image/srgb.h"
#include "tests/common/image/reading_error.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/png_bytes.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using testing::HasSubstr;

using namespace test::png_bytes;

TEST(Png, APaletteGivesItsColoursAndTheirAlpha) {
  const std::string palette = chunk(std::string("PLTE\xff\0\0\0\x33\0", 10)) + chunk(std::string("tRNS\x80", 5));
  const DecodedImage image = decode_image(png(2, 1, 8, 3, palette, stored(std::string("\0\0\1", 3))), "a.png");
  EXPECT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  ASSERT_EQ(image.samples.size(), 8U);
  EXPECT_FLOAT_EQ(image.samples[0], 1.0F);
  EXPECT_FLOAT_EQ(image.samples[3], 128.0F / 255.0F);
  EXPECT_FLOAT_EQ(image.samples[5], 0.2F);
  EXPECT_FLOAT_EQ(image.samples[7], 1.0F);
  EXPECT_TRUE(image.integer_samples);
}

TEST(Png, BitsAreBlackAndWhite) {
  const DecodedImage image = decode_image(png(3, 1, 1, 0, "", stored(std::string("\0\xa0", 2))), "a.png");
  EXPECT_EQ(image.channels, std::vector<std::string>{"Y"});
  EXPECT_EQ(image.samples, (std::vector<float>{1.0F, 0.0F, 1.0F}));
}

TEST(Png, SixteenBitsKeepTheirLevels) {
  const DecodedImage image = decode_image(png(1, 1, 16, 0, "", stored(std::string("\0\x12\x34", 3))), "a.png");
  EXPECT_FLOAT_EQ(image.samples.at(0), static_cast<float>(0x1234) / 65535.0F);
}

/// What reading writes to stderr, and what it throws.
std::pair<std::string, std::string> written_and_thrown(const std::string& bytes) {
  testing::internal::CaptureStderr();
  std::string thrown = "nothing";
  try {
    decode_image(bytes, "a.png");
  } catch (const InputError& error) {
    thrown = error.what();
  }
  return {testing::internal::GetCapturedStderr(), thrown};
}

TEST(Png, ItsLibraryWritesNothing) {
  const std::string row("\0\x40", 2), good = png(1, 1, 8, 0, "", stored(row));
  EXPECT_EQ(written_and_thrown(good), std::pair(std::string(), std::string("nothing")));

  const std::string odd_gamma = png(1, 1, 8, 0, chunk("gAMAxyz"), stored(row));
  EXPECT_EQ(written_and_thrown(odd_gamma), std::pair(std::string(), std::string("nothing"))) << "what it would warn of";

  const auto [written, thrown] = written_and_thrown(png(1, 1, 8, 0, "", "\x78\x01no deflate stream"));
  EXPECT_EQ(written, "");
  EXPECT_THAT(thrown, HasSubstr("a.png: cannot be read as an image ("));

  std::string line_ends = good;
  line_ends[7] = '\v';  // as a transfer of text leaves it
  const auto [written_then, thrown_then] = written_and_thrown(line_ends);
  EXPECT_EQ(written_then, "");
  EXPECT_THAT(thrown_then, HasSubstr("cannot be read as an image"));
}

TEST(Png, TooFewRowsAreAnError) {
  const auto [written, thrown] = written_and_thrown(png(1, 3, 8, 0, "", stored(std::string("\0\x40", 2))));
  EXPECT_EQ(written, "");
  EXPECT_THAT(thrown, HasSubstr("cannot be read as an image"));
}

std::string numbers(const std::vector<std::uint32_t>& values) {
  std::string bytes;
  for (const std::uint32_t value : values) bytes += big_endian(value);
  return bytes;
}

// Encoded 0x80, 0x40, 0x20: one pixel.
const std::string& colour_row() {
  static const std::string row("\0\x80\x40\x20", 4);
  return row;
}

/// One pixel of those levels in a file with these chunks.
ImageFile pixel_with(const std::string& chunks) {
  const test::ScratchFolder folder;
  const std::string bytes = png(1, 1, 8, 2, chunks, stored(colour_row()));
  write_file_atomically(folder / "a.png", bytes);
  return read_image_file(folder / "a.png");
}

// In hundred-thousandths; white first.
const std::vector<std::uint32_t> chromaticities_of_srgb{31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
const std::vector<std::uint32_t> chromaticities_of_p3{31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000};

TEST(Png, GammaIsFollowed) {
  const ImageFile linear = pixel_with(chunk("gAMA" + big_endian(100000)));
  EXPECT_FLOAT_EQ(linear.image.pixels[0].r, 128.0F / 255.0F);
  EXPECT_FLOAT_EQ(linear.image.pixels[0].b, 32.0F / 255.0F);
  const ImageFile half = pixel_with(chunk("gAMA" + big_endian(50000)));
  EXPECT_FLOAT_EQ(half.image.pixels[0].g, std::pow(64.0F / 255.0F, 2.0F));
  EXPECT_TRUE(half.warnings.empty());
}

TEST(Png, ChromaticitiesAreFollowedAfterTheCurve) {
  const Rgb same = pixel_with(chunk("cHRM" + numbers(chromaticities_of_srgb))).image.pixels[0];
  EXPECT_FLOAT_EQ(same.r, srgb_to_linear(128.0F / 255.0F));
  // Linear Display P3 to sRGB, both of the white D65, to the four digits in which the matrix is published (CSS Color 4, 12).
  const Rgb p3 = pixel_with(chunk("gAMA" + big_endian(100000)) + chunk("cHRM" + numbers(chromaticities_of_p3))).image.pixels[0];
  const float r = 128.0F / 255.0F, g = 64.0F / 255.0F, b = 32.0F / 255.0F;
  EXPECT_NEAR(p3.r, 1.2249F * r - 0.2247F * g, 2e-4F);
  EXPECT_NEAR(p3.g, -0.0420F * r + 1.0419F * g, 2e-4F);
  EXPECT_NEAR(p3.b, -0.0197F * r - 0.0786F * g + 1.0979F * b, 2e-4F);
}

TEST(Png, TheChunkSrgbStandsForTheOthers) {
  const Rgb pixel = pixel_with(chunk("gAMA" + big_endian(100000)) + chunk("cHRM" + numbers(chromaticities_of_p3)) +
                               chunk(std::string("sRGB\0", 5)))
                        .image.pixels[0];
  EXPECT_FLOAT_EQ(pixel.r, srgb_to_linear(128.0F / 255.0F));
  EXPECT_FLOAT_EQ(pixel.g, srgb_to_linear(64.0F / 255.0F));
}

TEST(Png, ColourChunksThatSayNothingAreNamed) {
  const ImageFile nothing = pixel_with(chunk("gAMA" + big_endian(0)) + chunk("cHRM" + std::string(4, '\0')));
  EXPECT_FLOAT_EQ(nothing.image.pixels[0].r, srgb_to_linear(128.0F / 255.0F));
  EXPECT_THAT(nothing.warnings, testing::ElementsAre(HasSubstr("gAMA"), HasSubstr("cHRM")));
  EXPECT_THAT(pixel_with(chunk(std::string("cICP\x09\x10\0\1", 8))).warnings, testing::ElementsAre(HasSubstr("cICP")));
  EXPECT_TRUE(pixel_with(chunk(std::string("cICP\x01\x0d\0\1", 8))).warnings.empty());
}

TEST(Png, AProfileIsNamedUnlessItIsThatOfSrgb) {
  const auto profile = [](const std::string& keyword, const std::string& description) {
    return chunk("iCCP" + keyword + std::string(2, '\0') + stored(test::icc_profile(description)));
  };
  EXPECT_THAT(pixel_with(profile("icc", "Adobe RGB (1998)")).warnings,
              testing::ElementsAre("its embedded colour profile \"Adobe RGB (1998)\" is not applied"));
  EXPECT_TRUE(pixel_with(profile("icc", "sRGB IEC61966-2.1")).warnings.empty());
  // What libpng does not take for a profile has its keyword.
  EXPECT_THAT(pixel_with(chunk(std::string("iCCPodd\0\0", 9) + stored("no profile"))).warnings,
              testing::ElementsAre("its embedded colour profile \"odd\" is not applied"));
}

}  // namespace
}  // namespace gibench
