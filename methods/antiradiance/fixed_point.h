/// A solver of x = b + M x, where M is known by what it does to a vector; it reports honestly how that went.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>

#include "common/method/task.h"

namespace gibench::antiradiance {

using Vector = Eigen::VectorXf;
/// out = M in; both have the same size.
using LinearMap = std::function<void(const Vector& in, Vector& out)>;

enum class Iteration { neumann, damped, krylov };

struct FixedPointRule {
  /// ‖b + M x − x‖ over ‖x‖ at which a series or damped steps end; BiCGSTAB's is over ‖b‖ where that is less, as the x of a
  /// singular system grows without bound.
  double residual = 1e-4;
  int most_iterations = 200;
  int exactly = 0;  ///< more than 0: so many terms of the plain series, whatever the residual does: for pictures of the iteration
  bool series_only = false;  ///< no other way is tried: the caller has a better one
  /// Steps over which a residual must fall. Terms of negative light alone grow until they have passed every surface in line.
  std::size_t patience = 8;
  double rounding = 0.0;  ///< share of a vector that M rounds off: where terms swell, what they leave is summed again
};

struct FixedPointOutcome {
  Termination termination = Termination::converged;
  std::string message;
  Iteration ended_with = Iteration::neumann;
  int applications = 0;  ///< of M
  double residual = 0.0;
};

/// The plain series b + M b + M² b + …; where its terms grow, or fade too slowly to end within the bound, the step damped to a
/// half; where that grows or is slow, too, BiCGSTAB (Eigen) on (I − M) x = b. A residual is held to be growing where
/// it is larger than eight steps before: terms may swell at first, as negative light chases positive.
FixedPointOutcome solve_fixed_point(const Vector& b, const LinearMap& map, const FixedPointRule& rule, Vector& x, Task& task);

}  // namespace gibench::antiradiance
