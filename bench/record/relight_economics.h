/// The worth of a relit frame: path tracing's time for the same error, and the frames after which preparation has paid.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "common/metrics/errors.h"

namespace gibench {

/// A number known within bounds: `value` is absent where the reference's noise hides it, an end where nothing bounds it.
struct Bounded {
  std::optional<double> value, low, high;
};

/// A path-traced answer at the same points: what it took and how far it is from the truth.
struct PathTraced {
  double seconds = 0.0;
  double rmse = 0.0;   ///< standard error of the values, root mean square over points and channels
  double paths = 1.0;  ///< a value, over all replicates
};

/// The same at `asked` points instead of at `compared`: path tracing takes as long at every point.
PathTraced at_as_many_points(const PathTraced& traced, std::size_t compared, std::size_t asked);

/// Seconds of path tracing to the error `rmse` (in the unit of `traced.rmse`): the squared error of independent paths falls
/// as one over their number, so s = seconds · (traced.rmse / rmse)², and never less than one path a value takes. The interval is
/// that of the error. Of an error below the reference's noise floor only the upper end is known, so only `low` is.
Bounded path_tracing_seconds(const PathTraced& traced, const ErrorValue& rmse);

/// How many times a frame's seconds path tracing takes.
Bounded times_cheaper(const Bounded& path_tracing_seconds, double frame_seconds);

/// The least n with prepare + n · frame ≤ n · path tracing: `high` is absent where path tracing may be as fast as the
/// frame, `low` where nothing bounds path tracing's time. All are whole.
Bounded frames_that_pay(double prepare_seconds, double frame_seconds, const Bounded& path_tracing_seconds);

/// Median of each number; what is absent counts as larger than all, and a median that is absent stays absent.
Bounded median_of(std::span<const Bounded> numbers);
double median_of(std::span<const double> numbers);

}  // namespace gibench
