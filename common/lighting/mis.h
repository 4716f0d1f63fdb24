/// Multiple importance sampling. Veach 1997, section 9.2.
#pragma once

namespace gibench {

/// The power heuristic (β = 2): weight of a sample drawn with density `own`, which another technique could have drawn
/// with density `other`; each already multiplied by its number of samples. Takes densities of any size.
inline float power_heuristic(float own, float other) {
  if (!(other > 0.0F)) return 1.0F;
  const float ratio = other / own;
  return 1.0F / (1.0F + ratio * ratio);
}

}  // namespace gibench
