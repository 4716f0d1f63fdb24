#include "reports/writing/page_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <glm/gtc/packing.hpp>

#include "common/core/error.h"
#include "common/core/hash.h"
#include "common/core/write_failure.h"
#include "common/image/image_layers.h"
#include "reports/tables/study_tables.h"

namespace gibench::report {
namespace {

namespace fs = std::filesystem;
using Pixels = std::vector<Rgb>;

/// Values beyond this are scaled down before they become half floats, whose largest is 65504.
constexpr float largest_half = 60000.0F;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

float largest(const Pixels& pixels) {
  float most = 0.0F;
  for (const Rgb& pixel : pixels)
    for (const float value : {pixel.r, pixel.g, pixel.b})
      if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

std::vector<std::uint8_t> half_bytes(const Pixels& pixels, float scale) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(pixels.size() * 6);
  for (const Rgb& pixel : pixels) {
    for (const float value : {pixel.r, pixel.g, pixel.b}) {
      const std::uint16_t half = glm::packHalf1x16(value / scale);
      bytes.push_back(static_cast<std::uint8_t>(half & 0xFFU));
      bytes.push_back(static_cast<std::uint8_t>(half >> 8U));
    }
  }
  return bytes;
}

/// Equal pixels go into one file: methods share, say, the direct light.
PageLayer write_layer(const Pixels& pixels, const fs::path& data_folder, const std::string& slug) {
  PageLayer layer;
  layer.scale = std::max(1.0F, largest(pixels) / largest_half);
  const auto bytes = half_bytes(pixels, layer.scale);
  const std::string name = fmt::format("images/{}/{:016x}.js", slug, hash_bytes(bytes.data(), bytes.size()));
  layer.file = name;
  const fs::path file = data_folder / name;
  if (fs::exists(file)) return layer;
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << "gibench.storePixels(\"" << name << "\", \"" << base64(bytes) << "\");\n";
  if (!out.flush()) throw_write_failure(file, "cannot be written", errno, "choose another --out");
  return layer;
}

Pixels half_difference(const Pixels& a, const Pixels& b) {
  Pixels noise(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    noise[i] = Rgb{0.5F * std::abs(a[i].r - b[i].r), 0.5F * std::abs(a[i].g - b[i].g), 0.5F * std::abs(a[i].b - b[i].b)};
  return noise;
}

PagePicture write_picture(const fs::path& file, const fs::path& data_folder, const std::string& slug) {
  const auto layers = read_exr_layers(file);
  if (layers.empty()) throw InputError(file.string(), "has no R, G, B channels");
  PagePicture picture;
  picture.width = layers.begin()->second.width;
  picture.height = layers.begin()->second.height;
  const auto add = [&](const std::string& name, const Pixels& pixels) {
    picture.layers[name] = write_layer(pixels, data_folder, slug);
  };
  const bool split = layers.contains("direct") && layers.contains("indirect");
  if (split) {
    add("direct", layers.at("direct").pixels);
    add("indirect", layers.at("indirect").pixels);
  } else if (layers.contains("")) {
    add("total", layers.at("").pixels);
  }
  if (layers.contains("half_a") && layers.contains("half_b"))
    add("noise", half_difference(layers.at("half_a").pixels, layers.at("half_b").pixels));
  return picture;
}

}  // namespace

std::vector<PagePicture> write_pictures(const Study& study, std::size_t scene, const fs::path& data_folder,
                                        std::vector<std::string>& warnings) {
  std::vector<PagePicture> pictures;
  const std::string slug = scene_slug(study, scene);
  const auto add = [&](const fs::path& file, std::optional<std::size_t> run) {
    if (file.empty() || !fs::exists(file)) return;
    try {
      pictures.push_back(write_picture(file, data_folder, slug));
      pictures.back().run = run;
    } catch (const InputError& error) {
      warnings.push_back(without_folder(study, error.what()));
    }
  };
  add(study.scenes[scene].reference_folder / "reference.exr", std::nullopt);
  for (const std::size_t run : study.runs_of(study.scenes[scene].name))
    if (!study.runs[run].folder.empty()) add(study.runs[run].folder / "image.exr", run);
  return pictures;
}

}  // namespace gibench::report
