/// PNG files of kinds that gibench does not write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "common/image/decoded_image.h"
#include "common/image/srgb.h"
#include "tests/common/image/reading_error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using testing::HasSubstr;

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xffU);
  return bytes;
}

std::string chunk(const std::string& letters_and_data) {
  boost::crc_32_type checksum;
  checksum.process_bytes(letters_and_data.data(), letters_and_data.size());
  return big_endian(static_cast<std::uint32_t>(letters_and_data.size() - 4)) + letters_and_data + big_endian(checksum.checksum());
}

/// A zlib stream of one block that is not compressed.
std::string stored(const std::string& data) {
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521U;
    b = (b + a) % 65521U;
  }
  const auto length = static_cast<unsigned>(data.size());
  std::string stream = "\x78\x01\x01";
  for (const unsigned half : {length, ~length}) {
    stream += static_cast<char>(half & 0xffU);
    stream += static_cast<char>(half >> 8 & 0xffU);
  }
  return stream + data + big_endian(b << 16 | a);
}

/// `kind`: 0 grey, 2 colours, 3 palette; `rows`: each begins with the number of its filter, 0.
std::string png(std::uint32_t width, std::uint32_t height, char depth, char kind, const std::string& more_chunks,
                const std::string& pixel_stream) {
  return std::string("\x89PNG\r\n\x1a\n", 8) +
         chunk("IHDR" + big_endian(width) + big_endian(height) + depth + kind + std::string(3, '\0')) + more_chunks +
         chunk("IDAT" + pixel_stream) + chunk("IEND");
}

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

}  // namespace
}  // namespace gibench
