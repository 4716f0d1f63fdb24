#include "bench/measure/measuring_fields.h"

namespace gibench {

std::span<const OptionField<MeasuringOptions>> measuring_fields() {
  using O = MeasuringOptions;
  constexpr std::size_t most_bounces = 1'000'000;
  static const OptionField<O> fields[] = {
      {"--surface-samples", "surface_samples", "Surface samples at which irradiance is compared", &O::surface_samples, 1,
       100'000'000, true},
      {"--surface-domain", "surface_domain",
       "Surfaces on which irradiance is compared: seen (by a camera, or by one diffuse reflection from there), all (what is not "
       "sealed away from light and cameras), whole, or names of objects joined by commas; without it: seen where the scene has a "
       "camera, else all",
       &O::surface_domain},
      {"--pixel-samples", "pixel_samples", "Camera rays per pixel, a square number", &O::pixel_samples, 1, 4096, true},
      {"--camera", "camera", "Camera by name; without it: the scene's first", &O::camera},
      {"--width", "image_width", "Width of the picture in pixels, its shape kept; 0: the camera's own", &O::image_width, 0,
       16384},
      {"--no-pictures", "pictures", "Surface samples alone, no camera picture", &O::pictures},
      {"--light-paths", "", "Only these paths, an expression such as C.{0,1}[LOB]|CDD+[LOB]; without it: all", &O::light_paths},
      {"--bounces", "bounces", "Reflections between a light and the surface asked about, at most; without it: all", &O::bounces,
       0, most_bounces},
  };
  return fields;
}

std::vector<std::string> arguments_of(const MeasuringOptions& options) { return arguments_of(measuring_fields(), options); }

}  // namespace gibench
