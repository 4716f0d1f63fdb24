#include "bench/measure/relight_options.h"

namespace gibench {

std::span<const OptionField<RelightOptions>> relight_fields() {
  using O = RelightOptions;
  constexpr std::size_t most_surface_samples = 100'000'000, most_reference_samples = std::size_t{1} << 20U;
  static const OptionField<O> fields[] = {
      {"--frames", "frames", "How many frames; without it as the file says", &O::frames, 1, 1'000'000},
      {"--surface-samples", "surface_samples", "Surface samples at which a frame's irradiance is asked", &O::surface_samples, 1,
       most_surface_samples, true},
      {"--compared-samples", "compared_samples",
       "Surface samples at which frames are compared; path tracing's time is scaled to all samples; 0: all of them",
       &O::compared_samples, 0, most_surface_samples, true},
      {"--reference-samples", "reference_samples",
       "Paths per value in each of the eight path-traced replicates that a frame is compared with; 0: no errors",
       &O::reference_samples, 0, most_reference_samples, true},
  };
  return fields;
}

std::vector<std::string> arguments_of(const RelightOptions& options) { return arguments_of(relight_fields(), options); }

}  // namespace gibench
