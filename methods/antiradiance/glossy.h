/// The part of K that is not diffuse: a material's lobe between directional bins.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/sampling.h"
#include "common/reflectance/bsdf.h"
#include "common/scene/scene.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/lobe_albedo.h"

namespace gibench::antiradiance {

/// The lobes of the scene's glossy materials, at the leaves that have one.
class GlossyReflection {
 public:
  GlossyReflection(const Scene& scene, std::span<const std::uint32_t> leaf_materials, const DirectionBins& bins);

  bool is_glossy(std::size_t leaf) const { return bsdf_of_leaf_[leaf] >= 0; }

  /// Adds to `exitant` (radiance by bin, W/(m² sr), three floats each) `scale` times what the lobe makes of `arriving`
  /// (irradiance by bin, W/m²) on the front of a leaf. `projected`: of projected_bins().
  void reflect(std::size_t leaf, const Vec3& normal, std::span<const float> projected, const float* arriving, float scale,
               float* exitant) const;

  /// Radiance towards a unit direction, W/(m² sr), of the lobe alone. A surrounding of one radiance gives that times the
  /// lobe's albedo.
  Rgb radiance(std::uint32_t material, const Vec3& normal, const Vec3& toward_viewer, std::span<const float> projected,
               const float* arriving) const;

 private:
  friend class LeafLobe;
  struct Lobe {
    SurfaceBsdf bsdf;
    LobeAlbedo albedo;
  };

  const DirectionBins& bins_;
  std::vector<Lobe> lobes_;
  std::vector<int> bsdf_of_leaf_;  ///< −1: diffuse
  std::vector<int> bsdf_of_material_;
};

/// The lobe on the front of one leaf, which takes light from any direction and gives it to the bins.
class LeafLobe {
 public:
  /// The leaf must be glossy; all arguments must outlive this.
  LeafLobe(const GlossyReflection& glossy, std::size_t leaf, const Vec3& normal, std::span<const float> projected);

  /// Adds to `exitant` what the lobe makes of `irradiance`, W/m², from the unit direction `toward_light`. Over all bins that is
  /// as much as the lobe's albedo says, unless its peak lies so far between the middles of bins that it would have to be raised
  /// by more than twofold.
  void reflect(const Vec3& toward_light, const Rgb& irradiance, float* exitant);

 private:
  const GlossyReflection::Lobe& lobe_;
  Frame frame_;
  std::vector<std::size_t> bins_;  ///< of the front
  std::vector<Vec3> local_;        ///< their directions
  std::vector<float> projected_;
  std::vector<Rgb> values_;
};

/// Why the bins cannot hold a material's lobe; empty where they can.
std::string too_narrow_for_bins(const Material& material, int bins);

}  // namespace gibench::antiradiance
