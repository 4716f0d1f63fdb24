/// Colour, shape and dash of each method, the same in every plot: distinguishable without colour too.
#pragma once

#include <string>
#include <vector>

#include "reports/collect/study.h"

namespace gibench::report {

struct MethodStyle {
  std::string method;
  std::string colour;     ///< Okabe and Ito's palette, which colour-blind readers can tell apart
  std::string shape;      ///< a Vega symbol
  std::vector<int> dash;  ///< stroke dash lengths in pixels; empty: solid
};

/// One style for each method of the study, in the order in which the methods appear, the path tracer first. A known
/// method looks the same in every report; the others take what is left.
std::vector<MethodStyle> method_styles(const Study& study);

}  // namespace gibench::report
