#include "common/image/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/random.h"
#include "common/image/image_layers.h"
#include "common/image/srgb.h"
#include "tests/common/image/reading_error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::reading_error;
using test::ScratchFolder;
using testing::HasSubstr;

Image noise_image(int width, int height, float largest_value) {
  Image image{width, height, {}};
  RandomStream random(3, 1, 0);
  for (int i = 0; i < width * height; ++i)
    image.pixels.push_back(largest_value * Rgb(random.next_float(), random.next_float(), random.next_float()));
  return image;
}

TEST(Image, AnExrKeepsEveryBit) {
  const ScratchFolder folder;
  Image image = noise_image(37, 21, 50.0F);
  image.pixels[3] = {-1.5F, 1e-30F, 3e38F};
  const ImageLayer layer{"", image.pixels};
  write_exr(folder / "a.exr", image.width, image.height, std::span(&layer, 1));
  const ImageFile back = read_image_file(folder / "a.exr");
  EXPECT_TRUE(back.high_dynamic_range);
  EXPECT_EQ(back.image.width, 37);
  EXPECT_EQ(back.image.height, 21);
  EXPECT_EQ(back.image.pixels, image.pixels);
}

TEST(Image, AnExrCarriesLayersAndHeader) {
  const ScratchFolder folder;
  const Image total = noise_image(16, 9, 2.0F), direct = noise_image(16, 9, 1.0F);
  std::vector<Rgb> indirect;
  for (const Rgb& pixel : total.pixels) indirect.push_back(0.25F * pixel);
  const std::vector<ImageLayer> layers{{"", total.pixels}, {"direct", direct.pixels}, {"indirect", indirect}};
  const std::vector<std::pair<std::string, std::string>> header{{"gibench.method", "meshless"}, {"gibench.seed", "7"}};
  write_exr(folder / "a.exr", 16, 9, layers, header);
  EXPECT_EQ(read_image(folder / "a.exr").pixels, total.pixels);
  EXPECT_EQ(read_image_file(folder / "a.exr", "direct").image.pixels, direct.pixels);
  const ImageFile back = read_image_file(folder / "a.exr", "indirect");
  EXPECT_EQ(back.image.pixels, indirect);
  EXPECT_EQ(back.header.at("gibench.method"), "meshless");
  EXPECT_EQ(back.header.at("gibench.seed"), "7");
  EXPECT_THROW(read_image_file(folder / "a.exr", "variance"), InputError);
  const std::map<std::string, Image> all = read_exr_layers(folder / "a.exr");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all.at("").pixels, total.pixels);
  EXPECT_EQ(all.at("direct").pixels, direct.pixels);
  EXPECT_EQ(all.at("indirect").pixels, indirect);
}

TEST(Image, ScanlinesOfFloats) {
  const ScratchFolder folder;
  const Image image = noise_image(8, 8, 1.0F);
  const ImageLayer layer{"", image.pixels};
  write_exr(folder / "a.exr", 8, 8, std::span(&layer, 1));
  const std::string bytes = read_file(folder / "a.exr");
  ASSERT_GT(bytes.size(), 8U);
  EXPECT_EQ(bytes.substr(0, 4), "\x76\x2f\x31\x01");
  EXPECT_EQ(bytes[4], 2);                                       // file format version
  EXPECT_EQ(static_cast<unsigned char>(bytes[5]) & 0x1aU, 0U);  // neither tiled, nor deep, nor in parts
  const auto channel = bytes.find(std::string("R\0", 2) + std::string("\2\0\0\0", 4));
  EXPECT_NE(channel, std::string::npos) << "channel R holds 32-bit floats (pixel type 2)";
}

TEST(Image, APngIsSrgbOfEightBits) {
  const ScratchFolder folder;
  const Image image{
      4, 1, {Rgb(0.0F), Rgb(0.5F, 0.25F, 0.001F), Rgb(1.0F), Rgb(7.0F, -1.0F, std::numeric_limits<float>::quiet_NaN())}};
  write_png(folder / "a.png", image);
  const ImageFile back = read_image_file(folder / "a.png");
  EXPECT_FALSE(back.high_dynamic_range);
  ASSERT_EQ(back.image.pixels.size(), 4U);
  EXPECT_EQ(back.image.pixels[0], Rgb(0.0F));
  // 0.5 is 187.5161 of 255 encoded: level 188; 0.25 is 136.9587: level 137; 0.001 is 3.2946: level 3.
  EXPECT_FLOAT_EQ(back.image.pixels[1].r, srgb_to_linear(188.0F / 255.0F));
  EXPECT_FLOAT_EQ(back.image.pixels[1].g, srgb_to_linear(137.0F / 255.0F));
  EXPECT_FLOAT_EQ(back.image.pixels[1].b, srgb_to_linear(3.0F / 255.0F));
  EXPECT_EQ(back.image.pixels[2], Rgb(1.0F));
  EXPECT_EQ(back.image.pixels[3], Rgb(1.0F, 0.0F, 0.0F));
}

TEST(Image, EveryLevelOfAPngComesBack) {
  const ScratchFolder folder;
  Image image{256, 1, {}};
  for (int i = 0; i < 256; ++i) image.pixels.push_back(Rgb(srgb_to_linear(static_cast<float>(i) / 255.0F)));
  write_png(folder / "a.png", image);
  EXPECT_EQ(read_image(folder / "a.png").pixels, image.pixels);
}

TEST(Image, MissingAndForeignFilesAreNamed) {
  const ScratchFolder folder;
  EXPECT_THAT(reading_error(folder / "none.exr"), HasSubstr((folder / "none.exr").string() + ": no such image file"));
  EXPECT_THAT(reading_error(folder.path()), HasSubstr("no such image file"));
  std::ofstream(folder / "text.png") << "this is not a picture";
  EXPECT_THAT(reading_error(folder / "text.png"), HasSubstr("cannot be read as an image"));
  std::ofstream(folder / "empty.exr").close();
  EXPECT_THAT(reading_error(folder / "empty.exr"), HasSubstr("cannot be read as an image"));
  std::ofstream(folder / "picture.unknown") << "this is not a picture";
  EXPECT_THAT(reading_error(folder / "picture.unknown"), HasSubstr("cannot be read as an image"));
}

TEST(Image, AChangedByteOfAPngIsFound) {
  const ScratchFolder folder;
  write_png(folder / "a.png", noise_image(16, 16, 1.0F));
  const std::string whole = read_file(folder / "a.png");
  for (const std::size_t place : {std::size_t{18}, whole.size() / 2, whole.size() - 2}) {
    std::string bytes = whole;
    bytes[place] = static_cast<char>(bytes[place] ^ 0x10);
    write_file_atomically(folder / "changed.png", bytes);
    EXPECT_THAT(reading_error(folder / "changed.png"), HasSubstr("cannot be read as an image")) << place;
  }
}

TEST(Image, ABrokenHeaderAsksForNoMemory) {
  const ScratchFolder folder;
  const Image image = noise_image(4, 4, 1.0F);
  const ImageLayer layer{"", image.pixels};
  write_exr(folder / "a.exr", 4, 4, std::span(&layer, 1));
  std::string bytes = read_file(folder / "a.exr");
  for (const char* window : {"dataWindow", "displayWindow"}) {
    const std::size_t corner = bytes.find(window) + std::string(window).size() + std::string("\0box2i\0....", 12).size() + 8;
    for (std::size_t i = 0; i < 8; ++i) bytes[corner + i] = i % 4 == 3 ? '\x0f' : '\xff';  // xMax = yMax = 0x0fffffff
  }
  write_file_atomically(folder / "huge.exr", bytes);
  EXPECT_THAT(reading_error(folder / "huge.exr"), HasSubstr("cannot be read as an image"));
}

TEST(Image, AnUnwritablePlaceIsNamedAndNothingIsLeft) {
  const ScratchFolder folder;
  const Image image = noise_image(4, 4, 1.0F);
  const ImageLayer layer{"", image.pixels};
  const std::filesystem::path nowhere = folder / "no" / "such" / "a.exr";
  try {
    write_exr(nowhere, 4, 4, std::span(&layer, 1));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(nowhere.string()));
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
  EXPECT_THROW(write_png(folder / "no" / "a.png", image), InputError);
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(Image, AFailedWriteKeepsTheOldPicture) {
  const ScratchFolder folder;
  const Image image = noise_image(4, 4, 1.0F);
  // A folder of the picture's name cannot be replaced by a file.
  std::filesystem::create_directory(folder / "a.png");
  std::ofstream(folder / "a.png" / "inside") << "kept";
  EXPECT_THROW(write_png(folder / "a.png", image), InputError);
  EXPECT_EQ(read_file(folder / "a.png" / "inside"), "kept");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(Image, AWriteReplacesAndLeavesNoTemporary) {
  const ScratchFolder folder;
  const Image first = noise_image(4, 4, 1.0F), second = noise_image(5, 5, 1.0F);
  write_png(folder / "a.png", first);
  write_png(folder / "a.png", second);
  EXPECT_EQ(read_image(folder / "a.png").width, 5);
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(Image, TheSamePictureGivesTheSameBytes) {
  const ScratchFolder folder;
  const Image image = noise_image(40, 30, 1.0F);
  const ImageLayer layer{"", image.pixels};
  for (const char* name : {"a", "b"}) {
    write_exr(folder / (std::string(name) + ".exr"), 40, 30, std::span(&layer, 1));
    write_png(folder / (std::string(name) + ".png"), image);
  }
  EXPECT_EQ(read_file(folder / "a.exr"), read_file(folder / "b.exr"));
  EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
}

}  // namespace
}  // namespace gibench
