/// The part of K that is not diffuse: a material's lobe between directional bins.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/reflectance/bsdf.h"
#include "common/scene/scene.h"
#include "methods/antiradiance/bins.h"

namespace gibench::antiradiance {

/// The lobes of the scene's glossy materials, at the leaves that have one.
class GlossyReflection {
 public:
  GlossyReflection(const Scene& scene, std::span<const std::uint32_t> leaf_materials, const DirectionBins& bins);

  bool is_glossy(std::size_t leaf) const { return bsdf_of_leaf_[leaf] >= 0; }

  /// Adds to `exitant` (radiance by bin, W/(m² sr), four floats each) what the lobe makes of `arriving` (irradiance by bin, W/m²)
  /// on the front of a leaf. `projected`: of projected_bins(). A lobe never gives back more than it is given.
  void reflect(std::size_t leaf, const Vec3& normal, std::span<const float> projected, const float* arriving,
               float* exitant) const;

  /// Radiance towards a unit direction, W/(m² sr), of the lobe alone.
  Rgb radiance(std::uint32_t material, const Vec3& normal, const Vec3& toward_viewer, std::span<const float> projected,
               const float* arriving) const;

 private:
  Rgb lobe(std::size_t bsdf, const Vec3& out, const Vec3& in) const;

  const DirectionBins& bins_;
  std::vector<SurfaceBsdf> bsdfs_;
  std::vector<Rgb> most_reflected_;  ///< of each lobe
  std::vector<int> bsdf_of_leaf_;    ///< −1: diffuse
  std::vector<int> bsdf_of_material_;
};

/// Why the bins cannot hold a material's lobe; empty where they can.
std::string too_narrow_for_bins(const Material& material, int bins);

}  // namespace gibench::antiradiance
