/// The common part of the modes with linked elements: links, sums, a solution on the elements, and its interpolation.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/interreflection.h"
#include "methods/antiradiance/strategy.h"

namespace gibench::antiradiance {

class LinkedStrategy : public Strategy {
 public:
  using Strategy::Strategy;

  Capabilities capabilities() const override;
  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) override;
  void light(const World& world, const EffectPlan& plan, const PlannedLights& lights, Task& task, StageReport& report) override;
  void shade(const World& world, const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const override;
  std::size_t bytes() const override;

 protected:
  /// `hides`: some surface may hide another.
  virtual Visibility visibility(const EffectPlan& plan, bool hides) const = 0;
  /// Forgets what prepare() and light() made, or light() alone.
  virtual void clear_all() {}
  virtual void clear_light() {}
  /// The elements' indirect light; `materials` of the leaves.
  virtual Interreflection solve(const World& world, const EffectPlan& plan, const PlannedLights& lights,
                                std::span<const std::uint32_t> materials, Surfaces& surfaces, std::span<const Rgb> direct,
                                Task& task);
  /// Light other than diffuse that an element's surface sends towards the viewer, W/(m² sr).
  virtual Rgb lobe_radiance(const World&, std::uint32_t /*element*/, const SurfaceSample&, const Vec3& /*toward_viewer*/) const {
    return {};
  }

  const Discretisation& parts() const { return *parts_; }
  const Linking& linking() const { return linking_; }
  const std::vector<float>& closure() const { return closure_; }

 private:
  Visibility visibility_on(const World& world, const EffectPlan& plan) const;
  void link(const World& world, const EffectPlan& plan, std::span<const float> radiosity, Task& task, StageReport& report);
  std::vector<float> foreseen_radiosity(std::span<const Rgb> direct, std::span<const Rgb> albedo) const;
  /// How many answers were not interpolated as a point of an open surface is.
  struct Exceptions {
    std::uint64_t clamped = 0;    ///< of negative light
    std::uint64_t uncovered = 0;  ///< without an element around them
    std::uint64_t inside = 0;     ///< taken for inside geometry
    std::uint64_t cut_off = 0;    ///< that other surfaces hide from all elements around them
  };
  Rgb indirect(const World& world, const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t seed, RayStream& rays,
               Exceptions& exceptions) const;

  std::unique_ptr<Discretisation> parts_;
  Linking linking_;
  std::vector<float> closure_;
  std::vector<Rgb> indirect_;  ///< irradiance at every vertex, W/m²
};

}  // namespace gibench::antiradiance
