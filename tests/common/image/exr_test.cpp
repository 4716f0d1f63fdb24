/// EXR files of kinds that gibench does not write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/core/atomic_file.h"
#include "common/image/image_file.h"
#include "common/image/primaries.h"
#include "tests/common/image/reading_error.h"
#include "tests/support/exr_bytes.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::exr_bytes;
using test::exr_floats;
using test::ExrPart;
using test::ScratchFolder;
using testing::HasSubstr;

constexpr Chromaticities aces_ap0{0.7347F, 0.2653F, 0.0F, 1.0F, 0.0001F, -0.077F, 0.32168F, 0.33767F};

/// Two rows of two pixels.
ExrPart colours(const std::vector<Rgb>& pixels) {
  ExrPart part{2, 2, {{"B", {}}, {"G", {}}, {"R", {}}}, {}, {}};
  for (const Rgb& pixel : pixels)
    for (int channel = 0; channel < 3; ++channel)
      part.channels[static_cast<std::size_t>(2 - channel)].samples.push_back(pixel[channel]);
  return part;
}

const std::vector<Rgb> four_pixels{Rgb(1.0F, 0.0F, 0.0F), Rgb(0.0F, 1.0F, 0.0F), Rgb(0.25F, 0.5F, 8.0F), Rgb(3.0F)};

ExrPart with_chromaticities(const Chromaticities& chromaticities) {
  ExrPart part = colours(four_pixels);
  part.attributes.push_back({"chromaticities", "chromaticities", exr_floats({chromaticities.begin(), chromaticities.end()})});
  return part;
}

ImageFile read_bytes(const std::string& bytes) {
  const ScratchFolder folder;
  write_file_atomically(folder / "a.exr", bytes);
  return read_image_file(folder / "a.exr");
}

std::string error_of_bytes(const std::string& bytes) {
  const ScratchFolder folder;
  write_file_atomically(folder / "a.exr", bytes);
  return test::reading_error(folder / "a.exr");
}

TEST(Exr, ColoursOfOtherPrimariesAreConverted) {
  const std::vector<Rgb> read = read_bytes(exr_bytes({with_chromaticities(aces_ap0)})).image.pixels;
  const ColourConversion convert = ColourConversion::to_rec709(aces_ap0).value();
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], convert(four_pixels[i])) << i;
  EXPECT_NE(read[0], four_pixels[0]);
}

TEST(Exr, ColoursOfRec709StayToTheBit) {
  EXPECT_EQ(read_bytes(exr_bytes({colours(four_pixels)})).image.pixels, four_pixels);
  EXPECT_EQ(read_bytes(exr_bytes({with_chromaticities(rec709_chromaticities)})).image.pixels, four_pixels);
}

TEST(Exr, GreyHasNoPrimaries) {
  ExrPart grey{2, 1, {{"Y", {0.5F, 2.0F}}}, {}, {}};
  grey.attributes.push_back({"chromaticities", "chromaticities", exr_floats({aces_ap0.begin(), aces_ap0.end()})});
  EXPECT_EQ(read_bytes(exr_bytes({grey})).image.pixels, (std::vector<Rgb>{Rgb(0.5F), Rgb(2.0F)}));
}

TEST(Exr, ChromaticitiesThatSpanNothingAreRefused) {
  const Chromaticities line{0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F};
  EXPECT_THAT(error_of_bytes(exr_bytes({with_chromaticities(line)})), HasSubstr("chromaticities of its header span no colours"));
  EXPECT_THAT(error_of_bytes(exr_bytes({with_chromaticities(Chromaticities{})})), HasSubstr("span no colours"));
}

TEST(Exr, OfSeveralPartsTheColoursAreReadAndTheOthersNamed) {
  ExrPart beauty = colours(four_pixels);
  beauty.name = "beauty";
  const ExrPart depth{2, 2, {{"Z", {1.0F, 2.0F, 3.0F, 4.0F}}}, {}, "depth"};
  const ExrPart grey{2, 2, {{"Y", {1.0F, 2.0F, 3.0F, 4.0F}}}, {}, "mask"};
  for (const std::vector<ExrPart>& parts :
       {std::vector<ExrPart>{depth, beauty, grey}, {grey, depth, beauty}, {beauty, depth, grey}}) {
    const ImageFile read = read_bytes(exr_bytes(parts));
    EXPECT_EQ(read.image.pixels, four_pixels);
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_THAT(read.warnings[0], HasSubstr("only \"beauty\" is read, not "));
    EXPECT_THAT(read.warnings[0], HasSubstr("\"depth\""));
    EXPECT_THAT(read.warnings[0], HasSubstr("\"mask\""));
  }
  EXPECT_TRUE(read_bytes(exr_bytes({beauty})).warnings.empty());
}

TEST(Exr, OfTwoPicturesTheFirstIsRead) {
  ExrPart first = colours(four_pixels), second = colours(std::vector<Rgb>(4, Rgb(7.0F)));
  first.name = "left", second.name = "right";
  const ImageFile read = read_bytes(exr_bytes({first, second}));
  EXPECT_EQ(read.image.pixels, four_pixels);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_THAT(read.warnings[0], HasSubstr("\"right\""));
}

TEST(Exr, LuminanceAndChromaAreRefusedByName) {
  const ExrPart halved{2, 2, {{"BY", {0.1F}, 2}, {"RY", {0.2F}, 2}, {"Y", {1.0F, 2.0F, 3.0F, 4.0F}}}, {}, {}};
  const ExrPart whole{1, 1, {{"BY", {0.1F}}, {"RY", {0.2F}}, {"Y", {1.0F}}}, {}, {}};
  for (const ExrPart& part : {halved, whole})
    EXPECT_THAT(error_of_bytes(exr_bytes({part})),
                HasSubstr("holds luminance and chroma (channels Y, RY, BY), which are not read"));
}

TEST(Exr, ACubeMapSaysThatItIsOne) {
  ExrPart cube{1, 6, {{"B", std::vector<float>(6)}, {"G", std::vector<float>(6)}, {"R", std::vector<float>(6)}}, {}, {}};
  EXPECT_FALSE(read_bytes(exr_bytes({cube})).is_cube_map());
  cube.attributes = {{"envmap", "envmap", std::string(1, '\0')}};  // latitude and longitude
  EXPECT_FALSE(read_bytes(exr_bytes({cube})).is_cube_map());
  cube.attributes = {{"envmap", "envmap", std::string(1, '\1')}};
  EXPECT_TRUE(read_bytes(exr_bytes({cube})).is_cube_map());
}

/// The bytes of a small picture with the four bytes after `name`, its type and `further` bytes replaced.
std::string with_number(std::string bytes, const std::string& name_and_type, std::size_t further, unsigned number) {
  const std::size_t place = bytes.find(name_and_type) + name_and_type.size() + further;
  for (std::size_t i = 0; i < 4; ++i) bytes[place + i] = static_cast<char>(number >> (8 * i) & 0xffU);
  return bytes;
}

TEST(Exr, AttributesLongerThanTheFileAreFoundBeforeTheyAreRead) {
  const std::string bytes = exr_bytes({colours(four_pixels)});
  const std::string attribute("pixelAspectRatio\0float\0", 23);
  for (const unsigned length : {1339389715U, 0x7fffffffU, 0xffffffffU})
    EXPECT_THAT(error_of_bytes(with_number(bytes, attribute, 0, length)),
                HasSubstr("an attribute of its header is longer than the file"));
}

TEST(Exr, PixelsThatTheFileCannotHoldAreFoundBeforeTheyAreRead) {
  const std::string bytes = exr_bytes({colours(four_pixels)});
  const std::string window("dataWindow\0box2i\0", 17);
  const char* const problem = "its header states more pixels than a file of its length can hold";
  constexpr std::size_t right = 4 + 8, bottom = 4 + 12;
  EXPECT_THAT(error_of_bytes(with_number(bytes, window, right, 20000000)), HasSubstr(problem));
  EXPECT_THAT(error_of_bytes(with_number(bytes, window, bottom, 20000000)), HasSubstr(problem));
  EXPECT_THAT(error_of_bytes(with_number(bytes, window, right, 0xfffffff0U)), HasSubstr("has no pixels"));
}

TEST(Exr, ControlCharactersOfAFileAreNotPassedOn) {
  const std::string bytes = exr_bytes({{1, 1, {{"R\x1b[31m\x0e", {1.0F}, 2}}, {}, {}}});
  for (const char c : error_of_bytes(bytes)) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
}

}  // namespace
}  // namespace gibench
