#include "common/metrics/metric_table.h"

#include <algorithm>

#include "common/core/overloaded.h"
#include "common/metrics/display_metrics.h"
#include "common/metrics/picture_errors.h"
#include "common/metrics/weighted_metrics.h"

namespace gibench {

namespace {

/// A metric that is defined for every reference.
template <MetricEstimate (*metric)(std::span<const Rgb>, const ReferenceMeans&)>
std::optional<MetricEstimate> always(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return metric(values, reference);
}

std::optional<double> displayed_psnr(int, int, std::span<const Rgb> display, std::span<const Rgb> reference) {
  return psnr(display, reference);
}

}  // namespace

const std::vector<Metric>& all_metrics() {
  static const std::vector<Metric> metrics = {
      {.name = "rmse",
       .title = "RMSE",
       .meaning = "root of mean (x − A)(x − B), in the unit of the values; the reference's noise does not count",
       .monte_carlo_slope = -0.5,
       .unit = MetricUnit::of_values,
       .function = ValueMetric{always<mean_squared_error>, Taken::as_root_of_square}},
      {.name = "relative_rmse",
       .title = "Relative RMSE",
       .meaning = "rmse over the mean of r",
       .monte_carlo_slope = -0.5,
       .unit = MetricUnit::share,
       .function = ValueMetric{relative_mean_squared_error, Taken::as_root_of_square}},
      {.name = "bias",
       .title = "Bias, absolute",
       .meaning = "mean of x − r over the mean of r",
       .better = Better::nearer_to_zero,
       .unit = MetricUnit::share,
       .function = ValueMetric{relative_bias, Taken::with_sign}},
      {.name = "rel_mse(0.01)",
       .title = "Relative MSE (0.01)",
       .meaning = "mean (x − A)(x − B) / (r² + 0.01 M²) over pairs A, B of replicates, r of the others, M the mean of r",
       .monte_carlo_slope = -1.0,
       .function = ValueMetric{relative_squared_error, Taken::as_square}},
      {.name = "rel_mse_trim(0.1%)",
       .title = "Relative MSE, trimmed (0.1%)",
       .meaning = "rel_mse(0.01) without the 0.1% of the values whose error is largest; between two bounds",
       .monte_carlo_slope = -1.0,
       .function = ValueMetric{trimmed_relative_squared_error_at_most, Taken::between, trimmed_relative_squared_error_at_least}},
      {.name = "mape(0.01)",
       .title = "MAPE (0.01)",
       .meaning = "mean |x − r| / (|r| + 0.01 M), M the mean of r; between two bounds",
       .monte_carlo_slope = -0.5,
       .unit = MetricUnit::share,
       .function = ValueMetric{percentage_error_at_most, Taken::between, percentage_error_at_least}},
      {.name = "smape(0.02)",
       .title = "SMAPE (0.02)",
       .meaning = "mean 2|x − r| / (|x| + |r| + 0.02 M), M the mean of r; between two bounds",
       .monte_carlo_slope = -0.5,
       .unit = MetricUnit::share,
       .function = ValueMetric{symmetric_error_at_most, Taken::between, symmetric_error_at_least}},
      {.name = "max",
       .title = "Largest error",
       .meaning = "largest |x − r|, in the unit of the values",
       .unit = MetricUnit::of_values,
       .function = ValueMetric{always<largest_error>, Taken::as_largest}},
      {.name = "psnr",
       .title = "PSNR (dB)",
       .meaning = "peak signal-to-noise ratio of the picture as it is shown, in dB; larger is better",
       .better = Better::larger,
       .function = PictureMetric{psnr_error, displayed_psnr}},
      {.name = "ssim",
       .title = "1 − SSIM",
       .meaning = "structural similarity of the picture as it is shown, 1 for equal pictures; 1 − SSIM is drawn",
       .better = Better::nearer_to_one,
       .function = PictureMetric{ssim_error, ssim}},
      {.name = "flip",
       .title = "FLIP",
       .meaning = "mean LDR-FLIP (Andersson et al. 2020) at the scene's exposure, 0 to 1",
       .function = PictureMetric{flip_error}},
      {.name = "hdr_flip",
       .title = "HDR-FLIP",
       .meaning = "mean HDR-FLIP (Andersson et al. 2021) over the scene's exposure range, 0 to 1",
       .function = PictureMetric{hdr_flip_error}},
  };
  return metrics;
}

const ValueMetric* value_metric(const Metric& metric) {
  return std::visit(Overloaded{[](const ValueMetric& found) { return &found; },
                               [](const PictureMetric&) -> const ValueMetric* { return nullptr; }},
                    metric.function);
}

const PictureMetric* picture_metric(const Metric& metric) {
  return std::visit(Overloaded{[](const PictureMetric& found) { return &found; },
                               [](const ValueMetric&) -> const PictureMetric* { return nullptr; }},
                    metric.function);
}

const Metric* find_metric(std::string_view name) {
  const auto found = std::ranges::find(all_metrics(), name, &Metric::name);
  return found == all_metrics().end() ? nullptr : &*found;
}

}  // namespace gibench
