/// Light at basis points: direct light, and what a gather brings.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/lighting/direct_light.h"
#include "common/method/task.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/gather.h"
#include "methods/meshless/refinement.h"
#include "methods/meshless/settings.h"
#include "methods/meshless/transport.h"

namespace gibench::meshless {

/// Estimates of light at basis points, with the samples and rays that its noise asks for.
class LightAtPoints {
 public:
  /// Looks at direct light at the coarsest samples to learn how noisy it is. `channels`: 1 where all are equal.
  LightAtPoints(const World& world, const Transport& transport, const DirectLight& light, const Settings& settings, int channels,
                Task& task);

  /// Whether the noise of direct light, or the settings, call for direct light in the basis.
  bool first_bounce_from_basis() const { return first_bounce_from_basis_; }
  /// Mean direct irradiance over the surfaces and the channels, W/m².
  double direct_mean() const { return direct_mean_; }
  int channels() const { return channels_; }

  /// Direct light in the basis.
  Coefficients direct();

  /// Estimates at points from what a sender sends. Gathers of different `number` use different random numbers. `keepers`
  /// keep what the rays of each gather met.
  void gather(const Sender& sender, int number, std::span<const std::uint32_t> points, std::span<Estimate> out,
              std::span<HitKeeper* const> keepers = {});

  RefinementRule rule() const;
  BasisSender sender_of(const Coefficients& coefficients) const {
    return BasisSender(coefficients, transport_.groups, settings_.epsilon_omega);
  }
  DirectSender direct_sender() const { return DirectSender(light_, hit_samples_, savings_); }

 private:
  void look_at_direct_light();
  double direct_variance();
  const Gatherer& gatherer_of(std::uint32_t point) const;
  SurfaceSample sample(std::uint32_t point) const;
  void sample_direct(std::span<const std::uint32_t> points, std::span<Estimate> out);
  void direct_estimates(std::span<const std::uint32_t> points, RayStream& rays, std::span<Estimate> out) const;

  const World& world_;
  const Transport& transport_;
  const DirectLight& light_;
  const Settings& settings_;
  int channels_;
  Task& task_;
  std::vector<Gatherer> gatherers_;  ///< of each level
  double direct_mean_ = 0.0;
  bool first_bounce_from_basis_ = false;
  int hit_samples_;     ///< light samples at a hit
  int point_samples_;   ///< at a basis point
  RaySavings savings_;  ///< at hits; of basis points those of hemisphere samples alone
};

}  // namespace gibench::meshless
