/// The surface points that a camera's pixels see, the same for every method and for the reference.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/lighting/direct_light.h"
#include "common/ray/world.h"

namespace gibench {

struct CameraPoints {
  int width = 0, height = 0;  ///< pixels
  int rays_per_pixel = 1;
  std::vector<SurfaceSample> samples;  ///< where a camera ray met a surface, by pixel, row-major from the top
  std::vector<Vec3> toward_viewer;     ///< unit; one per sample
  std::vector<std::uint32_t> pixel;    ///< one per sample
  std::vector<Rgb> background;         ///< one per pixel: what its rays that met nothing add to it, W/(m² sr)

  std::size_t pixel_count() const { return background.size(); }
  /// Mean over each pixel's rays of a value given at every sample; rays that met nothing count as 0.
  std::vector<Rgb> pixel_means(std::span<const Rgb> at_samples) const;
  /// Variance of that mean from independent variances at the samples.
  std::vector<Rgb> pixel_variances(std::span<const Rgb> at_samples) const;
};

/// p × p rays per pixel, stratified and jittered, for `rays_per_pixel` = p². Rows run from the top of the picture; the
/// vertical field of view spans the height. Keyed by the seed and the pixel: any number of threads gives the same points.
CameraPoints camera_points(const World& world, const DirectLight& light, const Camera& camera, int rays_per_pixel,
                           std::uint64_t seed, int threads);

/// The p of `rays_per_pixel` = p². Throws InputError at `place` for a number that is not a square.
int strata_per_side(int rays_per_pixel, const char* place);

}  // namespace gibench
