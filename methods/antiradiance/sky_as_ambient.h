/// Direct light of the accessibility mode: environments dimmed by accessibility, all other lights with traced shadows.
#pragma once

#include <cstdint>
#include <vector>

#include "common/core/rgb.h"
#include "common/lighting/direct_light.h"
#include "methods/antiradiance/accessibility.h"

namespace gibench::antiradiance {

/// Mean radiance of all environments over each sector of directions, W/(m² sr); over the whole sphere, as one, without
/// sectors.
std::vector<Rgb> sky_by_sector(const std::vector<Light>& lights, const DirectionBins* sectors);

class SkyAsAmbient {
 public:
  /// `sectors`: those of the accessibility that will be asked, or none.
  SkyAsAmbient(const World& world, const Lighting& lighting, const DirectLightOptions& options, const DirectionBins* sectors);

  /// Irradiance, W/m², or (with a direction towards the viewer) radiance, W/(m² sr), emission included. `of_samples`: how many
  /// are asked together, among which the light samples are shared.
  Rgb answer(const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t key, std::size_t of_samples,
             const Accessibility& accessibility, RayStream& rays) const;

 private:
  Rgb ambient(const SurfaceSample& sample, const Accessibility& accessibility) const;

  const World& world_;
  DirectLight others_;    ///< all lights but the environments
  std::vector<Rgb> sky_;  ///< of sky_by_sector()
  bool has_sky_ = false;
};

}  // namespace gibench::antiradiance
