#include "common/scene_io/pictures/picture_texels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/image/image_file.h"
#include "common/image/image_plugin.h"
#include "common/image/srgb.h"
#include "tests/support/png_bytes.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::ScratchFolder;
using testing::HasSubstr;

/// An uncompressed Targa picture of two texels from left to right, red-green-blue-alpha.
std::string targa(const std::array<unsigned char, 8>& levels) {
  std::string bytes(18, '\0');
  bytes[2] = 2;   // true colour
  bytes[12] = 2;  // width
  bytes[14] = 1;  // height
  bytes[16] = 32;
  bytes[17] = 8;  // bits of alpha
  for (const std::size_t i : {2U, 1U, 0U, 3U, 6U, 5U, 4U, 7U}) bytes += static_cast<char>(levels[i]);
  return bytes;
}

std::string exr(const std::vector<float>& rgba) {
  const std::vector<EncodedChannel> channels{{"R", rgba.data(), 4}, {"G", &rgba[1], 4}, {"B", &rgba[2], 4}, {"A", &rgba[3], 4}};
  std::vector<char> bytes;
  EXPECT_EQ(image_plugin().encode_exr(static_cast<int>(rgba.size() / 4), 1, channels, {}, bytes), "");
  return {bytes.begin(), bytes.end()};
}

TEST(PictureTexels, LevelsAreDecodedAndAlphaIsNot) {
  const PictureTexels picture = read_texels(targa({51, 102, 153, 128, 255, 0, 10, 255}), "leaf.tga");
  ASSERT_EQ(picture.width, 2);
  ASSERT_EQ(picture.height, 1);
  EXPECT_FLOAT_EQ(picture.texels[0].colour.r, srgb_to_linear(51.0F / 255.0F)) << "not multiplied by alpha";
  EXPECT_FLOAT_EQ(picture.texels[0].colour.b, srgb_to_linear(153.0F / 255.0F));
  EXPECT_FLOAT_EQ(picture.texels[0].opacity, 128.0F / 255.0F);
  EXPECT_FLOAT_EQ(picture.texels[1].colour.b, srgb_to_linear(10.0F / 255.0F));
  EXPECT_EQ(picture.texels[1].opacity, 1.0F);
}

TEST(PictureTexels, ColourSpacesOfFilesCountForColoursOnly) {
  using namespace test::png_bytes;
  const std::string linear = chunk("gAMA" + big_endian(100000)) + chunk(std::string("iCCPodd\0\0", 9) + stored("none"));
  const std::string bytes = png(1, 1, 8, 2, linear, stored(std::string("\0\x80\x40\x20", 4)));
  const PictureTexels as_stated = read_texels(bytes, "a.png"), as_srgb = read_texels(bytes, "a.png", TexelValues::srgb);
  const PictureTexels data = read_texels(bytes, "a.png", TexelValues::data);
  EXPECT_FLOAT_EQ(as_stated.texels[0].colour.r, 128.0F / 255.0F);
  EXPECT_THAT(as_stated.remarks, testing::ElementsAre(HasSubstr("colour profile \"odd\" is not applied")));
  EXPECT_FLOAT_EQ(as_srgb.texels[0].colour.r, srgb_to_linear(128.0F / 255.0F));
  EXPECT_TRUE(as_srgb.remarks.empty());
  EXPECT_FLOAT_EQ(data.texels[0].colour.g, 64.0F / 255.0F);
  EXPECT_TRUE(data.remarks.empty());
}

TEST(PictureTexels, DataStaysAsItStands) {
  const PictureTexels picture = read_texels(targa({51, 102, 153, 128, 255, 0, 10, 255}), "rough.tga", TexelValues::data);
  EXPECT_FLOAT_EQ(picture.texels[0].colour.g, 102.0F / 255.0F);
  EXPECT_FLOAT_EQ(picture.texels[0].colour.b, 153.0F / 255.0F);
  EXPECT_EQ(picture.texels[0].opacity, 1.0F);
}

TEST(PictureTexels, ColoursOfAnExrAreDividedByAlpha) {
  const PictureTexels picture = read_texels(exr({0.25F, 0.5F, 1.0F, 0.5F, 3.0F, 0.0F, 0.0F, 0.0F}), "a.exr");
  EXPECT_EQ(picture.texels[0].colour, Rgb(0.5F, 1.0F, 2.0F));
  EXPECT_EQ(picture.texels[0].opacity, 0.5F);
  EXPECT_EQ(picture.texels[1].colour, Rgb(3.0F, 0.0F, 0.0F)) << "light without a surface stays";
  EXPECT_EQ(picture.texels[1].opacity, 0.0F);
}

TEST(PictureTexels, AFileAndItsBytesAreTheSame) {
  const ScratchFolder folder;
  write_png(folder / "a.png", {2, 1, {Rgb(1.0F), Rgb(0.5F, 0.25F, 0.125F)}});
  const PictureTexels from_file = read_texels(folder / "a.png");
  const PictureTexels from_bytes = read_texels(read_file(folder / "a.png"), "inside the model");
  ASSERT_EQ(from_file.texels.size(), 2U);
  ASSERT_EQ(from_bytes.texels.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(from_file.texels[i].colour, read_image(folder / "a.png").pixels[i]);
    EXPECT_EQ(from_bytes.texels[i].colour, from_file.texels[i].colour);
    EXPECT_EQ(from_file.texels[i].opacity, 1.0F);
  }
}

std::string reading_error(std::string_view bytes, const std::string& name) {
  try {
    read_texels(bytes, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PictureTexels, WhatIsNoPictureIsNamed) {
  EXPECT_THAT(reading_error("this is not a picture", "inside.png"), HasSubstr("inside.png: cannot be read as an image"));
  EXPECT_THAT(reading_error("", "inside.png"), HasSubstr("inside.png: cannot be read as an image"));
  EXPECT_THAT(reading_error(exr({std::numeric_limits<float>::infinity(), 0.0F, 0.0F, 1.0F}), "a.exr"),
              HasSubstr("a.exr: a texel is not finite"));
  EXPECT_THROW(read_texels(std::filesystem::path("no/such/picture.png")), InputError);
}

TEST(PictureTexels, BytesNeedNoFileBesideThem) {
  const ScratchFolder folder;
  const std::string bytes = targa({1, 2, 3, 4, 5, 6, 7, 8});
  setenv("TMPDIR", (folder / "none").c_str(), 1);
  EXPECT_EQ(read_texels(bytes, "inside.tga").texels.size(), 2U);
  unsetenv("TMPDIR");
}

}  // namespace
}  // namespace gibench
