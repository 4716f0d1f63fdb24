/// Indirect light on the elements: the radiosity system in each of its forms.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/fixed_point.h"
#include "methods/antiradiance/glossy.h"
#include "methods/antiradiance/settings.h"

namespace gibench::antiradiance {

/// What light meets at the leaves, and how far it may go.
struct Surfaces {
  std::vector<Rgb> albedo;                   ///< diffuse reflectance of the fronts
  std::vector<float> closure;                ///< of closure_factors()
  const GlossyReflection* glossy = nullptr;  ///< further lobes, only with bins
  Vector glossy_direct;                      ///< of glossy_direct_radiance(); empty: none
  bool keeps_directions = false;             ///< the answer is wanted by direction, too; only with bins
  std::optional<int> max_bounces;
};

struct Interreflection {
  Termination termination = Termination::converged;
  std::string message;
  std::vector<Rgb> irradiance;  ///< of the leaves' fronts, W/m²; may be negative before the iteration has ended
  Vector by_direction;          ///< of the leaves × bins, W/m², where directions are kept; empty otherwise
  int iterations = 0;           ///< applications of the transport operator
  double residual = 0.0;
};

/// What each leaf's irradiance is multiplied by, and how the search for that ended.
struct Closure {
  std::vector<float> factors;
  Termination termination = Termination::done;
  std::string message;  ///< where the plain series did not do
  int iterations = 0;   ///< applications of the transport operator
};

/// So that a leaf's form factors sum to the share of its hemisphere that rays find closed (or to one at most, without rays):
/// then a uniform radiosity gives each leaf exactly what it should. With antiradiance the sum is that of the converged negative
/// light, too; where that does not converge there are no factors.
Closure closure_factors(const Discretisation& parts, const Linking& linking, const Settings& settings, Task& task);

/// `direct`: irradiance straight from the lights. Without a bound on bounces the whole system is solved at once; with one,
/// bounce by bounce, each with its visibility solved.
Interreflection interreflect(const Discretisation& parts, const Linking& linking, const Settings& settings,
                             const Surfaces& surfaces, std::span<const Rgb> direct, Task& task);

/// Value by value.
std::vector<Rgb> products(std::span<const Rgb> a, std::span<const Rgb> b);

}  // namespace gibench::antiradiance
