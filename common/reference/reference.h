/// A path-traced answer in independent replicates, and the question that it answers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/metrics/replicas.h"
#include "common/scene/scene.h"

namespace gibench {

/// What a reference is of; hashed into its folder's name.
struct ReferenceQuestion {
  std::string path_class;  ///< light-path expression, e.g. "C.*[LOB]", or with bounces "C.{0,3}[LOB]"
  std::uint64_t seed = 1;
  std::size_t surface_samples = 0;     ///< irradiance at this many samples of the surface domain
  std::optional<Camera> camera;        ///< radiance image; empty: surface samples only
  int pixel_samples = 1;               ///< camera rays per pixel
  std::string surface_domain = "all";  ///< of the surface samples: seen, all, whole, or names of objects joined by commas
};

/// direct and indirect replicates of one set of values.
struct ReferenceValues {
  Replicas direct, indirect;
};

/// The replicates of one question, and what they cost.
struct Reference {
  ReferenceQuestion question;
  std::uint64_t samples_per_replica = 0;        ///< paths for each value at the surface in each replicate
  std::uint64_t image_samples_per_replica = 0;  ///< for each pixel; 0 without a camera
  double seconds = 0.0;                         ///< spent so far on making it
  std::uint64_t points = 0;                     ///< fingerprint of the surface samples; 0: not known
  ReferenceValues surface;                      ///< W/m²
  ReferenceValues image;                        ///< W/(m² sr), row-major from the top
};

}  // namespace gibench
