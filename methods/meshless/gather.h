/// GATHER of Lehtinen et al. 2007, section 6.3: the irradiance at a point from rays into its hemisphere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/lighting/direct_light.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"
#include "methods/meshless/expansion.h"
#include "methods/meshless/groups.h"

namespace gibench::meshless {

/// What was met while senders were evaluated.
struct SenderCounts {
  std::uint64_t levels_used = 0;  ///< of the basis
  std::uint64_t uncovered = 0;    ///< hits that no basis function covers, and that send nothing
};

/// What a gather sees: the irradiance that arrives where its rays hit, before the reflection there.
class Sender {
 public:
  virtual ~Sender() = default;
  /// Irradiance at each hit, W/m², as seen from `receiver`. `key` fixes random numbers.
  virtual void irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t key, RayStream& rays,
                          std::span<Rgb> values, SenderCounts& counts) const = 0;
};

/// The previous bounce in the basis, as coarse as the threshold of the solid angle allows.
class BasisSender : public Sender {
 public:
  BasisSender(const Coefficients& coefficients, const Groups& groups, double epsilon_omega)
      : hierarchy_(coefficients.hierarchy()),
        expansion_(coefficients),
        groups_(groups),
        epsilon_omega_(static_cast<float>(epsilon_omega)) {}
  void irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t key, RayStream& rays,
                  std::span<Rgb> values, SenderCounts& counts) const override;
  std::size_t bytes() const { return expansion_.bytes(); }

 private:
  const Hierarchy& hierarchy_;
  Expansion expansion_;
  const Groups& groups_;
  float epsilon_omega_;
};

/// Light straight from the lights, evaluated at every hit by the shared evaluator.
class DirectSender : public Sender {
 public:
  /// See DirectLight::irradiance.
  DirectSender(const DirectLight& light, int samples, const RaySavings& savings)
      : light_(light), samples_(samples), savings_(savings) {}
  void irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t key, RayStream& rays,
                  std::span<Rgb> values, SenderCounts& counts) const override;

 private:
  const DirectLight& light_;
  int samples_;
  RaySavings savings_;
};

/// Two senders at once: the sum of what they send.
class BothSenders : public Sender {
 public:
  BothSenders(const Sender& first, const Sender& second) : first_(first), second_(second) {}
  void irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t key, RayStream& rays,
                  std::span<Rgb> values, SenderCounts& counts) const override;

 private:
  const Sender &first_, &second_;
};

/// Rays and buffers of one thread's gathers; made per chunk of a loop.
struct GatherBuffers {
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<SurfaceSample> lit;
  std::vector<std::uint32_t> ray_of_lit;
  std::vector<Rgb> albedos, values;
  /// Sums over neighbouring rays.
  struct Bins {
    std::vector<float> light, nearness;
  } bins;
  float reach = 0.0F;  ///< metres: the slope is wanted over so far, and what is nearer counts as so far away
  SenderCounts counts;
  std::uint64_t evaluations = 0;
};

/// An estimate and how far it may be off.
struct Estimate {
  Rgb value;
  float deviation = 0.0F;  ///< standard deviation of the largest channel's estimate
  float slope = 0.0F;      ///< that what is near and unlike the rest may cause, W/m² per metre; 0: not known
};

class Gatherer {
 public:
  /// A fixed pattern of `rays` cosine-distributed directions (Hammersley), ordered so that neighbours lie close.
  Gatherer(const World& world, int rays);

  /// Irradiance at a sample from light reflected by the surfaces that its rays hit, W/m²: Σ albedo · E(hit) / rays.
  /// The pattern is turned about the normal by an angle drawn from `key`; the albedo is that of the hit itself.
  /// The deviation is judged from four interleaved parts of the pattern, which makes it too large rather than too small. The
  /// slope is Σ |L − mean of L| / distance over the directions, L being what a direction brings.
  Estimate irradiance(const SurfaceSample& receiver, std::uint64_t key, const Sender& sender, RayStream& rays,
                      GatherBuffers& buffers) const;

  /// What the rays of the last gather would have brought with an irradiance of 1 at every hit: Σ albedo / rays.
  Estimate reflectance(const GatherBuffers& buffers) const;

  std::size_t rays() const { return pattern_.size(); }
  std::size_t bytes() const { return pattern_.capacity() * sizeof(Vec3); }

 private:
  float slope(const GatherBuffers& buffers, GatherBuffers::Bins& bins) const;
  void trace(const SurfaceSample& receiver, std::uint64_t key, RayStream& rays, GatherBuffers& buffers) const;
  void collect_lit_hits(GatherBuffers& buffers) const;

  const World& world_;
  std::vector<Vec3> pattern_;  ///< local directions, z along the normal
};

/// Whoever keeps of a gather what its hits serve for once more.
class HitKeeper {
 public:
  virtual ~HitKeeper() = default;
  /// Points that are about to be gathered.
  virtual void announce(std::span<const std::uint32_t> points) = 0;
  /// What the rays of a gather at a point met, which `buffers` hold. Calls for different points may run at the same time.
  virtual void keep(std::uint32_t point, const Gatherer& gatherer, GatherBuffers& buffers) = 0;
};

}  // namespace gibench::meshless
