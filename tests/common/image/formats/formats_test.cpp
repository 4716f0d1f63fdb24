#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/image/image_file.h"
#include "common/image/srgb.h"
#include "tests/common/image/formats/image_files.h"
#include "tests/common/image/reading_error.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::reading_error;
using test::ScratchFolder;
using testing::HasSubstr;

void cut_file(const std::filesystem::path& from, const std::filesystem::path& to, double share) {
  const std::string bytes = read_file(from);
  write_file_atomically(to, std::span(bytes.data(), static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
}

TEST(ImageFormats, ReadsGreyAlphaAndSixteenBits) {
  const ScratchFolder folder;
  test::write_sample_files(folder.path());
  // Levels as written by write_sample_files: encoded 0.2, 0.4, 0.6 of the range, 16 bits to 1/65535, 8 bits to 1/255.
  const auto decoded = [](double level, double range) {
    return srgb_to_linear(static_cast<float>(std::round(level * range) / range));
  };
  const Rgb grey8 = read_image(folder / "grey8.png").pixels[0];
  EXPECT_FLOAT_EQ(grey8.r, decoded(0.2, 255));
  EXPECT_EQ(grey8, Rgb(grey8.r));
  const Rgb rgb16 = read_image(folder / "rgb16.png").pixels[0];
  EXPECT_NEAR(rgb16.r, decoded(0.2, 65535), 1e-7);
  EXPECT_NEAR(rgb16.g, decoded(0.4, 65535), 1e-7);
  EXPECT_NEAR(rgb16.b, decoded(0.6, 65535), 1e-7);
  const Rgb with_alpha = read_image(folder / "rgba8.png").pixels[0];
  EXPECT_FLOAT_EQ(with_alpha.r, decoded(0.2, 255)) << "colours are not multiplied by alpha";
  EXPECT_FLOAT_EQ(with_alpha.g, decoded(0.4, 255));
  EXPECT_FLOAT_EQ(with_alpha.b, decoded(0.6, 255));
  const Rgb grey_alpha = read_image(folder / "grey_alpha8.png").pixels[0];
  EXPECT_FLOAT_EQ(grey_alpha.g, decoded(0.2, 255));
  const Rgb jpeg = read_image(folder / "rgb8.jpg").pixels[0];
  EXPECT_NEAR(jpeg.r, decoded(0.2, 255), 0.02);
  EXPECT_NEAR(jpeg.b, decoded(0.6, 255), 0.02);
}

TEST(ImageFormats, ReadsTiledHalfCroppedAndGreyExr) {
  const ScratchFolder folder;
  test::write_sample_files(folder.path());
  const Image tiled = read_image(folder / "tiled_half.exr");
  ASSERT_EQ(tiled.width, 70);
  ASSERT_EQ(tiled.height, 50);
  EXPECT_EQ(tiled.pixels[0], Rgb(0.0F, 0.0F, 2.0F));
  EXPECT_EQ(tiled.pixels[70U * 49U + 69U], Rgb(69.0F, 49.0F, 2.0F));
  EXPECT_EQ(read_image(folder / "grey.exr").pixels[5], Rgb(5.0F));
  const Image cropped = read_image(folder / "cropped.exr");
  ASSERT_EQ(cropped.width, 8);
  ASSERT_EQ(cropped.height, 6);
  EXPECT_EQ(cropped.pixels[0], Rgb(0.0F)) << "outside the data window";
  EXPECT_EQ(cropped.pixels[8U * 3U + 2U], Rgb(2.0F, 3.0F, 1.0F));
  const Image radiance = read_image(folder / "probe.hdr");
  EXPECT_NEAR(radiance.pixels[0].r, 12.5F, 0.1F);
  EXPECT_TRUE(read_image_file(folder / "probe.hdr").high_dynamic_range);
}

/// A JPEG with a profile behind its first mark (ICC.1:2010, annex B.4).
void add_profile(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& profile) {
  const std::string bytes = read_file(from), data = std::string("ICC_PROFILE\0\1\1", 14) + profile;
  const std::size_t length = data.size() + 2;
  const std::string segment = std::string("\xff\xe2") + static_cast<char>(length >> 8) + static_cast<char>(length & 0xff) + data;
  write_file_atomically(to, bytes.substr(0, 2) + segment + bytes.substr(2));
}

TEST(ImageFormats, ProfilesOfJpegsAreNamedUnlessTheyAreThatOfSrgb) {
  const ScratchFolder folder;
  test::write_sample_files(folder.path());
  add_profile(folder / "rgb8.jpg", folder / "p3.jpg", test::icc_profile("Display P3"));
  add_profile(folder / "rgb8.jpg", folder / "srgb.jpg", test::icc_profile("sRGB IEC61966-2.1"));
  EXPECT_TRUE(read_image_file(folder / "rgb8.jpg").warnings.empty());
  EXPECT_TRUE(read_image_file(folder / "srgb.jpg").warnings.empty());
  const ImageFile named = read_image_file(folder / "p3.jpg");
  EXPECT_THAT(named.warnings, testing::ElementsAre("its embedded colour profile \"Display P3\" is not applied"));
  EXPECT_EQ(named.image.pixels[0], read_image(folder / "rgb8.jpg").pixels[0]);
}

TEST(ImageFormats, TruncatedFilesAreRefused) {
  const ScratchFolder folder;
  test::write_sample_files(folder.path());
  Image image{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i) image.pixels.push_back(Rgb(0.5F + 0.5F * std::sin(static_cast<float>(i * i))));
  const ImageLayer layer{"", image.pixels};
  write_exr(folder / "whole.exr", 64, 64, std::span(&layer, 1));
  write_png(folder / "whole.png", image);
  for (const char* name : {"whole.exr", "whole.png", "tiled_half.exr", "rgb8.jpg", "probe.hdr", "rgb16.png"}) {
    ASSERT_NO_THROW(read_image(folder / name)) << name;
    for (const double share : {0.05, 0.5, 0.9, 0.9999}) {
      // A JPEG that lacks nothing but its end mark has all its pixels, and libjpeg says so.
      if (share > 0.99 && std::string(name).ends_with(".jpg")) continue;
      const std::filesystem::path cut = folder / ("cut_" + std::string(name));
      cut_file(folder / name, cut, share);
      EXPECT_THAT(reading_error(cut), HasSubstr("cannot be read as an image")) << name << " cut to " << share;
    }
  }
}

}  // namespace
}  // namespace gibench
