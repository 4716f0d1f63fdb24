/// The bounds.json of the truth suite: how near to the truth each rule's method has to come.
#pragma once

#include <map>
#include <string>

#include "truth_case.h"

namespace gibench::truth {

/// A bound of its own, wider than the rule's tolerance, and why it is needed.
struct MeasuredBound {
  double bound = 0.0;
  std::string cause;
};

/// Shares of a value, or of a tenth of the largest value of its group where that is more: a group is what is asked of one case in
/// one quantity, component and bounce bound.
struct Bounds {
  double tolerance = 0.02;                         ///< of every question that has no bound of its own
  double near_tolerance = 0.02;                    ///< the same near edges
  double near_ceiling = 0.02;                      ///< of the bounds near edges: no question there may be worse
  std::map<std::string, MeasuredBound> questions;  ///< by id: they miss the tolerance, and must keep these
  /// The same for what is asked near edges, by near_key().
  std::map<std::string, MeasuredBound> near_edges;

  /// Of a question of the case; `near` where it stands near an edge.
  double bound_of(const std::string& case_id, const Question& question, bool near) const;
};

/// "P24", or "P24 direct" of light that comes straight from lamps, which finite elements are often not asked for.
std::string near_key(const std::string& case_id, const Question& question);

/// By the name of the rule; one that the file does not have is held to 2%, and near edges to the ceiling that the file states
/// for new methods.
Bounds bounds_of(const std::string& rule);

}  // namespace gibench::truth
