#include "reports/tables/method_style.h"

#include <algorithm>
#include <set>

#include "reports/tables/ranking.h"

namespace gibench::report {
namespace {

/// Styles with the method each is kept for; black is the baseline's.
const std::vector<MethodStyle>& styles() {
  static const std::vector<MethodStyle> all = {
      {baseline_method, "#000000", "circle", {}},
      {"meshless", "#0072B2", "square", {7, 3}},
      {"spectral", "#D55E00", "triangle-up", {2, 2}},
      {"wavelet", "#009E73", "diamond", {8, 3, 2, 3}},
      {"antiradiance", "#CC79A7", "triangle-down", {4, 2}},
      {"ifield", "#E69F00", "cross", {10, 4}},
      {"", "#56B4E9", "triangle-right", {1, 3}},
      {"", "#7F7F7F", "triangle-left", {12, 3, 3, 3}},
  };
  return all;
}

}  // namespace

std::vector<MethodStyle> method_styles(const Study& study) {
  std::vector<std::string> methods;
  for (const StudyRun& run : study.runs)
    if (std::find(methods.begin(), methods.end(), run.method) == methods.end()) methods.push_back(run.method);
  std::stable_partition(methods.begin(), methods.end(), [](const std::string& method) { return method == baseline_method; });

  std::set<std::size_t> taken;
  const auto kept_for = [](const std::string& method) {
    const auto found =
        std::find_if(styles().begin(), styles().end(), [&](const MethodStyle& style) { return style.method == method; });
    return static_cast<std::size_t>(found - styles().begin());
  };
  for (const std::string& method : methods)
    if (const std::size_t style = kept_for(method); style < styles().size()) taken.insert(style);

  std::vector<MethodStyle> result;
  std::size_t next = styles().size() - 1;
  for (const std::string& method : methods) {
    std::size_t style = method.empty() ? styles().size() : kept_for(method);
    // From the end, so that the styles kept for known methods are given away last; beyond them styles repeat.
    for (std::size_t tries = 0; style >= styles().size(); ++tries, next = (next + styles().size() - 1) % styles().size())
      if (taken.insert(next).second || tries >= styles().size()) style = next;
    result.push_back(styles()[style]);
    result.back().method = method;
  }
  return result;
}

}  // namespace gibench::report
