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
  DirectSender(const DirectLight& light, int samples) : light_(light), samples_(samples) {}
  void irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t key, RayStream& rays,
                  std::span<Rgb> values, SenderCounts& counts) const override;

 private:
  const DirectLight& light_;
  int samples_;
};

/// Rays and buffers of one thread's gathers; made per chunk of a loop.
struct GatherBuffers {
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<SurfaceSample> lit;
  std::vector<std::uint32_t> ray_of_lit;
  std::vector<Rgb> albedos, values;
  SenderCounts counts;
  std::uint64_t evaluations = 0;
};

/// An estimate and how far it may be off.
struct Estimate {
  Rgb value;
  float deviation = 0.0F;  ///< standard deviation of the largest channel's estimate
};

class Gatherer {
 public:
  /// A fixed pattern of `rays` cosine-distributed directions (Hammersley), ordered so that neighbours lie close.
  Gatherer(const World& world, int rays);

  /// Irradiance at a sample from light reflected by the surfaces that its rays hit, W/m²: Σ albedo · E(hit) / rays.
  /// The pattern is turned about the normal by an angle drawn from `key`; the albedo is that of the hit itself.
  /// The deviation is judged from four interleaved parts of the pattern, which makes it too large rather than too small.
  Estimate irradiance(const SurfaceSample& receiver, std::uint64_t key, const Sender& sender, RayStream& rays,
                      GatherBuffers& buffers) const;

  std::size_t bytes() const { return pattern_.capacity() * sizeof(Vec3); }

 private:
  void trace(const SurfaceSample& receiver, std::uint64_t key, RayStream& rays, GatherBuffers& buffers) const;
  void collect_lit_hits(GatherBuffers& buffers) const;

  const World& world_;
  std::vector<Vec3> pattern_;  ///< local directions, z along the normal
};

}  // namespace gibench::meshless
