#include "reports/tables/metric_info.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace gibench::report {
namespace {

std::size_t position(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

const std::vector<MetricInfo>& known_metrics() {
  static const std::vector<MetricInfo> metrics = {
      {.name = "relative_rmse",
       .title = "Relative RMSE",
       .meaning = "root of mean (x − r)² over mean of r",
       .percent = true,
       .monte_carlo_slope = -0.5},
      {.name = "rmse",
       .title = "RMSE",
       .meaning = "root of mean (x − r)², in the unit of the values",
       .has_unit = true,
       .monte_carlo_slope = -0.5},
      {.name = "bias",
       .title = "Bias, absolute",
       .meaning = "mean of x − r over mean of r",
       .plotted = Plotted::absolute,
       .percent = true},
      {.name = "rel_mse(0.01)",
       .title = "Relative MSE (0.01)",
       .meaning = "mean (x − r)² / (r² + 0.01)",
       .monte_carlo_slope = -1.0},
      {.name = "rel_mse_trim(0.1%)",
       .title = "Relative MSE, trimmed (0.1%)",
       .meaning = "rel_mse(0.01) without the 0.1% largest terms",
       .monte_carlo_slope = -1.0},
      {.name = "mape(0.01)",
       .title = "MAPE (0.01)",
       .meaning = "mean |x − r| / (|r| + 0.01)",
       .percent = true,
       .monte_carlo_slope = -0.5},
      {.name = "smape(0.02)",
       .title = "SMAPE (0.02)",
       .meaning = "mean 2|x − r| / (|x| + |r| + 0.02)",
       .percent = true,
       .monte_carlo_slope = -0.5},
      {.name = "max", .title = "Largest error", .meaning = "largest |x − r|, in the unit of the values", .has_unit = true},
      {.name = "psnr",
       .title = "PSNR (dB)",
       .meaning = "peak signal-to-noise ratio of the exposed picture",
       .logarithmic = false,
       .higher_is_better = true},
      {.name = "ssim",
       .title = "1 − SSIM",
       .meaning = "structural similarity of the exposed picture; 1 − SSIM is drawn",
       .plotted = Plotted::one_minus,
       .higher_is_better = true},
      {.name = "flip", .title = "FLIP", .meaning = "mean FLIP at the scene's exposure"},
      {.name = "hdr_flip", .title = "HDR-FLIP", .meaning = "mean HDR-FLIP over the scene's exposure range"},
  };
  return metrics;
}

MetricInfo metric_info(const std::string& name) {
  for (const MetricInfo& metric : known_metrics())
    if (metric.name == name) return metric;
  return {.name = name, .title = name, .meaning = "as the record names it", .logarithmic = false};
}

double plotted_value(const MetricInfo& metric, double value) {
  switch (metric.plotted) {
    case Plotted::value: return value;
    case Plotted::absolute: return std::abs(value);
    case Plotted::one_minus: return 1.0 - value;
  }
  return value;
}

double badness(const MetricInfo& metric, double value) {
  if (metric.plotted != Plotted::value) return plotted_value(metric, value);
  return metric.higher_is_better ? -value : value;
}

std::vector<ErrorKey> measured_keys(const Study& study) {
  std::set<ErrorKey> found;
  for (const StudyRun& run : study.runs)
    for (const auto& [key, error] : run.errors) found.insert(key);
  std::vector<ErrorKey> keys(found.begin(), found.end());
  std::vector<std::string> metrics;
  for (const MetricInfo& metric : known_metrics()) metrics.push_back(metric.name);
  const auto order = [&metrics](const ErrorKey& key) {
    return std::tuple(position({"surface", "image"}, key.domain), position({"indirect", "total", "direct"}, key.component),
                      position(metrics, key.metric), key);
  };
  std::sort(keys.begin(), keys.end(), [&order](const ErrorKey& a, const ErrorKey& b) { return order(a) < order(b); });
  return keys;
}

std::string describe(const ErrorKey& key) {
  if (key.domain == "surface") return key.component + " irradiance at the surface samples";
  return key.domain == "image" ? key.component + " radiance in the camera image" : key.component + " light, " + key.domain;
}

std::string axis_title(const ErrorKey& key) {
  const MetricInfo metric = metric_info(key.metric);
  if (!metric.has_unit) return metric.title;
  return metric.title + (key.domain == "surface" ? " (W/m²)" : " (W/(m² sr))");
}

}  // namespace gibench::report
