#include "tests/common/image/formats/image_files.h"

#include <fmt/format.h>
// (after fmt: OpenImageIO bundles its own under the same guards)
#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace gibench::test {

namespace {

void write(const std::filesystem::path& file, const OIIO::ImageSpec& spec, const std::vector<float>& samples) {
  const auto output = OIIO::ImageOutput::create(file.string());
  const bool done = output && output->open(file.string(), spec) && output->write_image(OIIO::TypeDesc::FLOAT, samples.data()) &&
                    output->close();
  if (!done) throw std::runtime_error("sample file " + file.string() + " could not be written");
}

void write_constant(const std::filesystem::path& file, OIIO::TypeDesc type, int size, const std::vector<float>& pixel) {
  OIIO::ImageSpec spec(size, size, static_cast<int>(pixel.size()), type);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("CompressionQuality", 100);
  std::vector<float> samples;
  for (int i = 0; i < size * size; ++i) samples.insert(samples.end(), pixel.begin(), pixel.end());
  write(file, spec, samples);
}

}  // namespace

void write_sample_files(const std::filesystem::path& folder) {
  write_constant(folder / "grey8.png", OIIO::TypeDesc::UINT8, 16, {0.2F});
  write_constant(folder / "grey_alpha8.png", OIIO::TypeDesc::UINT8, 16, {0.2F, 0.5F});
  write_constant(folder / "rgb16.png", OIIO::TypeDesc::UINT16, 16, {0.2F, 0.4F, 0.6F});
  write_constant(folder / "rgba8.png", OIIO::TypeDesc::UINT8, 16, {0.2F, 0.4F, 0.6F, 0.5F});
  write_constant(folder / "rgb8.jpg", OIIO::TypeDesc::UINT8, 16, {0.2F, 0.4F, 0.6F});
  write_constant(folder / "probe.hdr", OIIO::TypeDesc::FLOAT, 16, {12.5F, 1.0F, 0.25F});

  OIIO::ImageSpec tiled(70, 50, 3, OIIO::TypeDesc::HALF);
  tiled.tile_width = tiled.tile_height = 32;
  std::vector<float> ramp;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 70; ++x) ramp.insert(ramp.end(), {static_cast<float>(x), static_cast<float>(y), 2.0F});
  write(folder / "tiled_half.exr", tiled, ramp);

  OIIO::ImageSpec grey(8, 8, 1, OIIO::TypeDesc::FLOAT);
  grey.channelnames = {"Y"};
  std::vector<float> grey_samples;
  for (int i = 0; i < 64; ++i) grey_samples.push_back(static_cast<float>(i % 8));
  write(folder / "grey.exr", grey, grey_samples);

  OIIO::ImageSpec cropped(4, 2, 3, OIIO::TypeDesc::FLOAT);
  cropped.x = 2, cropped.y = 3;
  cropped.full_width = 8, cropped.full_height = 6;
  std::vector<float> crop;
  for (int y = 3; y < 5; ++y)
    for (int x = 2; x < 6; ++x) crop.insert(crop.end(), {static_cast<float>(x), static_cast<float>(y), 1.0F});
  write(folder / "cropped.exr", cropped, crop);
}

}  // namespace gibench::test
