/// The rule by which pairs of nodes are refined into links.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace gibench::antiradiance {

/// Which sides exchange light.
enum class Facing {
  fronts,  ///< fronts send to fronts: real light
  both,    ///< backs send, too (antiradiance), and black backs receive
};

struct RefinementRule {
  Facing facing = Facing::fronts;
  /// The oracle accepts a pair when neither disc fills more than this share of the other's hemisphere (weighted by the cosines).
  float tolerance = 0.01F;
  /// Radiosity of every node, W/m²; then what is compared with the tolerance is form factor · radiosity · area over the mean of
  /// radiosity and the mean area of the elements. Empty: the geometry alone.
  std::span<const float> radiosity = {};
  float mean_radiosity = 0.0F;
  std::size_t most_links = std::numeric_limits<std::size_t>::max();
};

}  // namespace gibench::antiradiance
