/// The near hits of gathers, kept to correct what they were sent once finer levels are known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/gather.h"
#include "methods/meshless/groups.h"

namespace gibench::meshless {

/// A gather asks its senders for levels down to balls of epsilon_Omega. Of a solution on the coarse levels alone it gets no
/// finer ones, so that what is near is seen blurred, and in a corner half of what a point sees is near. The hits that called for
/// more are kept here, one of each run of neighbouring rays for all of them: the detail that they missed can be added without a
/// ray.
class NearHits : public HitKeeper {
 public:
  /// `levels`: those that the senders of the gathers hold. `seed` fixes which hits are kept.
  NearHits(const Hierarchy& hierarchy, const Groups& groups, std::uint32_t levels, double epsilon_omega, std::uint64_t seed);

  void announce(std::span<const std::uint32_t> points) override;
  void keep(std::uint32_t point, const Gatherer& gatherer, GatherBuffers& buffers) override;

  /// The irradiance that a function brings to each of the points from their near hits, at the levels that these called for.
  Coefficients arriving(const Coefficients& sent, Task& task) const;

  std::size_t size() const;  ///< hits that are kept
  std::size_t bytes() const;

 private:
  struct NearHit {
    Vec3 position{0.0F};
    std::uint32_t normal = 0;  ///< packed
    std::uint32_t group = 0;
    Rgb weight;  ///< its albedo / rays, over the chance that it was kept
  };

  const Hierarchy& hierarchy_;
  const Groups& groups_;
  float epsilon_omega_;
  std::uint64_t seed_;
  float reach_ = 0.0F;  ///< metres: nearer hits call for finer levels
  std::vector<std::uint32_t> points_;
  std::vector<std::uint32_t> slot_;  ///< of every point of the hierarchy, where it was announced
  std::vector<std::vector<NearHit>> hits_;
};

}  // namespace gibench::meshless
