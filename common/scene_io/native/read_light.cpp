#include "common/scene_io/native/read_light.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/core/names.h"
#include "common/image/image_file.h"
#include "common/scene/light_kinds.h"
#include "common/scene_io/native/read_values.h"

namespace gibench {

namespace {

using nlohmann::json;

float cosine_of(double degrees) { return static_cast<float>(std::cos(degrees * pi_double / 180.0)); }

/// Reads the picture; negative pixels become 0 with a warning, as filters of picture tools leave some.
std::shared_ptr<const EnvironmentImage> read_picture(const std::filesystem::path& file, const JsonPlace& place, Scene& scene) {
  auto picture = std::make_shared<EnvironmentImage>();
  try {
    ImageFile read = read_image_file(file);
    if (read.is_cube_map())
      throw InputError(file.string(), "holds the six faces of a cube",
                       "convert it to latitude and longitude, twice as wide as high");
    for (const std::string& warning : read.warnings) scene.warnings.push_back(file.filename().string() + ": " + warning);
    *picture = {read.image.width, read.image.height, std::move(read.image.pixels)};
  } catch (const InputError& error) {
    throw InputError(place.text(), error.what());
  }
  std::size_t negative = 0;
  for (Rgb& pixel : picture->pixels) {
    if (!is_finite(pixel))
      throw InputError(place.text(), "a pixel of " + in_quotes(file.string()) + " is not finite", "correct the picture");
    if (smallest(pixel) >= 0.0F) continue;
    pixel = {std::max(pixel.r, 0.0F), std::max(pixel.g, 0.0F), std::max(pixel.b, 0.0F)};
    ++negative;
  }
  if (negative > 0)
    scene.warnings.push_back(file.filename().string() + ": " + std::to_string(negative) +
                             " pixels with negative channels are raised to 0");
  return picture;
}

/// Fills a light of each kind from its JSON.
struct LightReader {
  const json& from;
  const JsonPlace& place;
  const std::filesystem::path& folder;
  SceneAssembler& assembler;

  void operator()(PointLight& light) const {
    light.position = assembler.to_local(read_vector(from["position"]));
    light.intensity = read_rgb(from["intensity"], place["intensity"]);
  }
  void operator()(SpotLight& light) const {
    const double inner = from["inner_degrees"].get<double>(), outer = from["outer_degrees"].get<double>();
    if (outer < inner)
      throw InputError(place["outer_degrees"].text(), "the outer cone is narrower than the inner one",
                       "make outer_degrees at least inner_degrees");
    light.position = assembler.to_local(read_vector(from["position"]));
    light.direction = Vec3(read_direction(from["direction"], place["direction"]));
    light.intensity = read_rgb(from["intensity"], place["intensity"]);
    light.cos_inner = cosine_of(inner);
    light.cos_outer = cosine_of(outer);
  }
  void operator()(DirectionalLight& light) const {
    light.direction = Vec3(read_direction(from["direction"], place["direction"]));
    light.irradiance = read_rgb(from["irradiance"], place["irradiance"]);
  }
  void operator()(EnvironmentLight& light) const {
    if (!from.contains("file")) {
      light.radiance = read_rgb(from["radiance"], place["radiance"]);
      return;
    }
    const JsonPlace file_place = place["file"];
    const auto file = find_file(from["file"].get<std::string>(), folder, file_place.text());
    light.image = read_picture(file, file_place, assembler.scene());
    if (from.contains("scale")) light.radiance = read_rgb(from["scale"], place["scale"]);
    light.rotate_y_degrees = static_cast<float>(std::remainder(from.value("rotate_y_degrees", 0.0), 360.0));
  }
};

}  // namespace

Light read_light(const json& light, const JsonPlace& place, const std::filesystem::path& folder, SceneAssembler& assembler) {
  std::optional<Light> read = light_of_kind(light["type"].get<std::string>());
  GIBENCH_CHECK(read.has_value(), "the schema lets only known kinds of light pass");
  std::visit(LightReader{light, place, folder, assembler}, *read);
  return *read;
}

}  // namespace gibench
