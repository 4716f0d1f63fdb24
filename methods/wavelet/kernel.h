/// The kernel of light transport between the surfaces of two nodes, integrated from samples.
#pragma once

#include <cstdint>

#include "common/core/random.h"
#include "common/method/task.h"
#include "common/ray/world.h"
#include "methods/wavelet/elements.h"
#include "methods/wavelet/settings.h"

namespace gibench::wavelet {

/// Both sides of one pair: the integral of V cos cos / (π r²) over both nodes.
struct Exchange {
  float total = 0.0F;         ///< m²; 0 where no light goes from one to the other
  Four receiver{}, sender{};  ///< m², share of each child; both have the total as their sum
  /// How much a wavelet on the node could take up: what the kernel, in the mean over the other node, spreads over this one, times
  /// the root of the product of both areas. Where no ray is free, what one that was missed would make of it.
  float receiver_spread = 0.0F, sender_spread = 0.0F;
};

struct KernelOptions {
  KernelForm form = KernelForm::polygons;
  bool tests_visibility = true;
  int rays = 16;  ///< of a pair of leaves; up to four times as many of larger ones, while these find all free or all blocked
  std::uint64_t seed = 1;
};

/// The default form: from points on either side the form factor of the other side's polygon in closed form, which has no 1/r²,
/// times the share of rays that nothing stops; the mean of both directions. So touching nodes are no special case, and the kernel
/// is symmetric.
class Kernel {
 public:
  Kernel(const World& world, const Elements& elements, const KernelOptions& options)
      : world_(world), elements_(elements), options_(options) {}

  Exchange between(std::uint32_t receiver, std::uint32_t sender, RayStream& rays) const;

 private:
  struct Sight;
  struct Segments;
  Exchange of_samples(std::uint32_t receiver, std::uint32_t sender, RayStream& rays) const;
  Segments draw(std::uint32_t receiver, std::uint32_t sender, int count, RandomStream& random) const;
  Sight look(std::uint32_t receiver, std::uint32_t sender, RayStream& rays) const;
  void trace(std::uint32_t receiver, std::uint32_t sender, int count, RandomStream& random, RayStream& rays, Sight& sight) const;

  const World& world_;
  const Elements& elements_;
  KernelOptions options_;
};

}  // namespace gibench::wavelet
