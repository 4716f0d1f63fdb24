#include "bench/app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace gibench {

namespace {

constexpr int most_bounces = 1000000;

}  // namespace

void add_bounces_option(CLI::App& verb, std::optional<int>& bounces) {
  verb.add_option("--bounces", bounces, "Reflections between a light and the surface asked about, at most; without it: all")
      ->check(CLI::Range(0, most_bounces));
}

void add_measuring_options(CLI::App& verb, MeasuringOptions& options) {
  verb.add_option("--surface-samples", options.surface_samples, "Surface samples at which irradiance is compared")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}))
      ->capture_default_str();
  verb.add_option("--pixel-samples", options.pixel_samples, "Camera rays per pixel, a square number")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  verb.add_option("--camera", options.camera, "Camera by name; without it: the scene's first");
  verb.add_option("--width", options.image_width, "Width of the picture in pixels, its shape kept; 0: the camera's own")
      ->check(CLI::Range(0, 16384));
  verb.add_flag_callback(
      "--no-pictures", [&options] { options.pictures = false; }, "Surface samples alone, no camera picture");
  add_bounces_option(verb, options.bounces);
}

void add_plan_options(CLI::App& verb, PlanOptions& options) {
  verb.add_option("--effects", options.effects,
                  "Effects that may be simulated, commas between; see gibench list effects. none: nothing; without it: all")
      ->take_last();
  verb.add_option("--tolerance", options.tolerance,
                  "Share of the light that bounces left out of the plan may hold; 0: none is left out")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

void add_light_paths_option(CLI::App& verb, std::string& light_paths) {
  verb.add_option("--light-paths", light_paths,
                  "Only these paths, an expression such as C.{0,1}[LOB]|CDD+[LOB]; without it: all");
}

std::string command_line_of(const MeasuringOptions& options) {
  const MeasuringOptions defaults;
  std::string line;
  if (options.surface_samples != defaults.surface_samples) line += fmt::format(" --surface-samples {}", options.surface_samples);
  if (options.pixel_samples != defaults.pixel_samples) line += fmt::format(" --pixel-samples {}", options.pixel_samples);
  if (!options.camera.empty()) line += " --camera " + options.camera;
  if (!options.pictures) line += " --no-pictures";
  if (options.image_width != 0) line += fmt::format(" --width {}", options.image_width);
  if (!options.light_paths.empty()) line += fmt::format(" --light-paths '{}'", options.light_paths);
  if (options.bounces) line += fmt::format(" --bounces {}", *options.bounces);
  if (options.reference_seed != defaults.reference_seed) line += fmt::format(" --seed {}", options.reference_seed);
  return line;
}

}  // namespace gibench
