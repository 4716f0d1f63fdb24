#include "common/scene_io/native/read_light.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/core/names.h"
#include "common/image/image_file.h"
#include "common/scene_io/native/read_values.h"

namespace gibench {

namespace {

using nlohmann::json;

float cosine_of(double degrees) { return static_cast<float>(std::cos(degrees * pi_double / 180.0)); }

SpotLight read_spot(const json& light, const JsonPlace& place, const SceneBuilder& builder) {
  const double inner = light["inner_degrees"].get<double>(), outer = light["outer_degrees"].get<double>();
  if (outer < inner)
    throw InputError(place["outer_degrees"].text(), "the outer cone is narrower than the inner one",
                     "make outer_degrees at least inner_degrees");
  SpotLight spot;
  spot.position = builder.to_local(read_vector(light["position"]));
  spot.direction = Vec3(read_direction(light["direction"], place["direction"]));
  spot.intensity = read_rgb(light["intensity"], place["intensity"]);
  spot.cos_inner = cosine_of(inner);
  spot.cos_outer = cosine_of(outer);
  return spot;
}

/// Reads the picture; negative pixels become 0 with a warning, as filters of picture tools leave some.
std::shared_ptr<const EnvironmentImage> read_picture(const std::filesystem::path& file, const JsonPlace& place, Scene& scene) {
  auto picture = std::make_shared<EnvironmentImage>();
  try {
    Image image = read_image(file);
    *picture = {image.width, image.height, std::move(image.pixels)};
  } catch (const InputError& error) {
    throw InputError(place.text(), error.what());
  }
  std::size_t negative = 0;
  for (Rgb& pixel : picture->pixels) {
    if (!is_finite(pixel))
      throw InputError(place.text(), "a pixel of " + in_quotes(file.string()) + " is not finite", "mend the picture");
    if (smallest(pixel) >= 0.0F) continue;
    pixel = {std::max(pixel.r, 0.0F), std::max(pixel.g, 0.0F), std::max(pixel.b, 0.0F)};
    ++negative;
  }
  if (negative > 0)
    scene.warnings.push_back(file.filename().string() + ": " + std::to_string(negative) +
                             " pixels with negative channels are raised to 0");
  return picture;
}

EnvironmentLight read_environment(const json& light, const JsonPlace& place, const std::filesystem::path& folder, Scene& scene) {
  EnvironmentLight environment;
  if (!light.contains("file")) {
    environment.radiance = read_rgb(light["radiance"], place["radiance"]);
    return environment;
  }
  const JsonPlace file_place = place["file"];
  const auto file = find_file(light["file"].get<std::string>(), folder, file_place.text());
  environment.image = read_picture(file, file_place, scene);
  if (light.contains("scale")) environment.radiance = read_rgb(light["scale"], place["scale"]);
  environment.rotate_y_degrees = static_cast<float>(std::remainder(light.value("rotate_y_degrees", 0.0), 360.0));
  return environment;
}

}  // namespace

Light read_light(const json& light, const JsonPlace& place, const std::filesystem::path& folder, SceneBuilder& builder) {
  const auto type = light["type"].get<std::string>();
  if (type == "spot") return read_spot(light, place, builder);
  if (type == "environment") return read_environment(light, place, folder, builder.scene());
  if (type == "point")
    return PointLight{builder.to_local(read_vector(light["position"])), read_rgb(light["intensity"], place["intensity"])};
  return DirectionalLight{Vec3(read_direction(light["direction"], place["direction"])),
                          read_rgb(light["irradiance"], place["irradiance"])};
}

}  // namespace gibench
