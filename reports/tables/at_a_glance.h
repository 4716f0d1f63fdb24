/// A study at a glance: what each configuration costs and gets right, and from where on it beats path tracing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/ranking.h"
#include "reports/tables/table.h"

namespace gibench::report {

/// A run beside path tracing to the same error, as far as the intervals decide.
enum class Verdict { ahead, behind, undecided };
Verdict verdict_of(const SpeedUp& speed);

/// From how many on, of points or of pictures, a run is cheaper than path tracing to the same error: preparing and lighting are
/// paid once, shading each time.
struct BreakEven {
  double number = 0.0;  ///< infinite: never, path tracing is cheaper each time
  /// What the interval of the speed-up leaves room for, infinite for never; empty where it does not say.
  std::optional<double> low = {}, high = {};
  bool at_most = false;       ///< the run's error is not resolved: it may pay earlier
  bool extrapolated = false;  ///< the path tracer was not run at that error
};
/// `asked` is how many were asked in the run: points, or one picture. Empty where the run or the path tracer does not say.
std::optional<BreakEven> break_even(const StudyRun& run, const std::optional<SpeedUp>& speed, Domain domain, double asked);

/// One configuration on one scene, the path tracer left out.
struct GlanceRow {
  std::size_t scene = 0, run = 0;  ///< positions in the study
  std::optional<SpeedUp> speed_up;
  std::optional<BreakEven> points, pictures;
};

/// Of runs with a result, in the order of the scenes, the fastest at its error first.
std::vector<GlanceRow> glance_rows(const Study& study, const ErrorKey& key);
Table glance_table(const Study& study, const ErrorKey& key, const std::vector<GlanceRow>& rows);

/// On how many scenes which method is ahead of path tracing, in words; one or two sentences.
std::string glance_sentence(const Study& study, const ErrorKey& key, const std::vector<GlanceRow>& rows);

}  // namespace gibench::report
