/// The shared direct-light evaluator: light straight from the lights, for every method that gives only
/// indirect light, and the next-event estimation of the path tracer.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "common/core/rgb.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"

namespace gibench {

/// What is known beforehand, and what is not wanted.
struct DirectLightOptions {
  bool tests_visibility = true;   ///< false: nothing lies between a lit side and a light that it faces
  bool surfaces_in_sight = true;  ///< false: no surface sees the front of another
  bool glossy = true;             ///< false: surfaces reflect with their diffuse lobe alone
};

/// Rays that are saved where the light of many points is averaged, as over the hits of a gather. The expectation stays.
struct RaySavings {
  float hemisphere_share = 1.0F;  ///< hemisphere samples for each light sample, (0, 1]; those taken count for the others, too
  float small_light = 0.0F;  ///< W/m²: what would bring less unhidden is tried by chance, in proportion, and brings that much
};

/// Immutable after construction, shared by all threads. Keeps references to neither argument but the World.
class DirectLight {
 public:
  DirectLight(const World& world, const Lighting& lighting, const DirectLightOptions& options = {});
  ~DirectLight();

  /// Radiance that the surface itself emits from the sample's side, W/(m² sr); zero from a back.
  Rgb emission(const SurfaceSample& sample) const;
  /// Radiance of the environment seen in a unit direction, W/(m² sr); zero without one.
  Rgb environment(const Vec3& direction) const;
  /// Whether there is no light at all.
  bool dark() const;
  const DirectLightOptions& options() const;

  /// Irradiance on the sample's side straight from all lights, W/m²: point, spot and directional lights exactly, one
  /// shadow ray each (up to 64 of them, else sampled); the rest by an unbiased estimate of `samples` samples of each group of
  /// lights and as many hemisphere samples, combined by multiple importance sampling. `key` fixes the random numbers: the same
  /// key gives the same bits. Zero on an unlit side.
  Rgb irradiance(const SurfaceSample& sample, std::uint64_t key, int samples, RayStream& rays) const;

  /// Radiance leaving the sample towards the unit direction `toward_viewer`: emission plus straight light
  /// reflected once, W/(m² sr). The same estimator with the surface's BRDF.
  Rgb radiance(const SurfaceSample& sample, const Vec3& toward_viewer, std::uint64_t key, int samples, RayStream& rays) const;

  /// Both at many points, each with a key: the values of the single calls up to the rounding of hits, the rays of neighbouring
  /// points in the same packets. The way to go where a point has few samples. All spans are of one length.
  void irradiance(std::span<const SurfaceSample> points, std::span<const std::uint64_t> keys, int samples, RayStream& rays,
                  std::span<Rgb> out, const RaySavings& savings = {}) const;
  void radiance(std::span<const SurfaceSample> points, std::span<const Vec3> toward_viewer, std::span<const std::uint64_t> keys,
                int samples, RayStream& rays, std::span<Rgb> out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gibench
