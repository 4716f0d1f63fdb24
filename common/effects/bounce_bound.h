/// The number of reflections that a scene's light needs.
#pragma once

#include <optional>
#include <string>

#include "common/ray/world.h"

namespace gibench {

/// What surfaces reflect at most, over channels, directions and lobes together, in [0, 1] for physical materials.
struct Reflectances {
  double largest = 0.0;           ///< of any material in use; a ggx surface reflects up to everything at grazing angles
  double area_weighted = 0.0;     ///< over the lit sides, at normal incidence: what a bounce keeps on average
  std::string brightest;          ///< name of the material of the largest
  bool brightest_grazes = false;  ///< it is the largest at grazing angles only
};
Reflectances reflectances_of(const World& world);

/// The largest number n of reflections whose light, with all that follows it, can exceed `tolerance` of the whole.
///
/// Let E be the irradiance on all lit sides, E = Σ E_k by the number k of reflections, and K the operator of one
/// reflection, E_{k+1} = K E_k. A reflection keeps at most the share ρ of the flux that arrives at any point, ρ the largest
/// directional-hemispherical reflectance, and none is added on the way: ‖K‖₁ ≤ ρ. So Σ_{k>n} E_k = K^{n+1} E holds at
/// most ρ^{n+1} of the flux of E. For diffuse surfaces the same holds of the largest value (‖K‖∞ ≤ ρ: an irradiance
/// is at most π times the largest radiance, which is ρ/π times the largest irradiance), and by Riesz and Thorin of every
/// norm between, the root mean square among them. n is then the least with ρ^{n+1} ≤ tolerance; for every n below it,
/// ρ^{n+1} exceeds the tolerance. Channels are bounded together by the largest. No bound, and why: ρ near one, where n
/// would exceed 1000. (An area-weighted albedo bounds nothing: the light may stay where it is bright.)
struct BounceBound {
  std::optional<int> most;
  std::string why;  ///< one line: the evidence
};
BounceBound bounce_bound(const Reflectances& reflectances, double tolerance);

}  // namespace gibench
