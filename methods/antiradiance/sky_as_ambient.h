/// Direct light of the accessibility mode: environments dimmed by accessibility, all other lights with traced shadows.
#pragma once

#include <cstdint>

#include "common/core/rgb.h"
#include "common/lighting/direct_light.h"
#include "methods/antiradiance/accessibility.h"

namespace gibench::antiradiance {

class SkyAsAmbient {
 public:
  SkyAsAmbient(const World& world, const Lighting& lighting, const DirectLightOptions& options);

  /// Irradiance, W/m², or (with a direction towards the viewer) radiance, W/(m² sr), emission included. `of_samples`: how many
  /// are asked together, among which the light samples are shared.
  Rgb answer(const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t key, std::size_t of_samples,
             const Accessibility& accessibility, RayStream& rays) const;

 private:
  const World& world_;
  DirectLight others_;  ///< all lights but the environments
  Rgb radiance_;        ///< mean over the sphere of all environments, W/(m² sr)
};

}  // namespace gibench::antiradiance
