#include "reports/tables/metric_info.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace gibench::report {
namespace {

template <class Item>
std::size_t position(const std::vector<Item>& items, const Item& item) {
  return static_cast<std::size_t>(std::find(items.begin(), items.end(), item) - items.begin());
}

}  // namespace

Metric metric_info(const std::string& name) {
  if (const Metric* metric = find_metric(name)) return *metric;
  return {.name = name, .title = name, .meaning = "as the record names it", .better = Better::unknown};
}

bool is_percentage(const Metric& metric) { return metric.unit == MetricUnit::share; }
bool is_logarithmic(const Metric& metric) { return metric.better != Better::larger && metric.better != Better::unknown; }
bool higher_is_better(const Metric& metric) { return metric.better == Better::larger || metric.better == Better::nearer_to_one; }

double plotted_value(const Metric& metric, double value) {
  switch (metric.better) {
    case Better::nearer_to_zero: return std::abs(value);
    case Better::nearer_to_one: return 1.0 - value;
    case Better::smaller:
    case Better::larger:
    case Better::unknown: return value;
  }
  return value;
}

std::pair<double, double> plotted_interval(const Metric& metric, double low, double high) {
  const double a = plotted_value(metric, low), b = plotted_value(metric, high);
  const bool around_no_error = metric.better == Better::nearer_to_zero && low < 0.0 && high > 0.0;
  return {around_no_error ? 0.0 : std::min(a, b), std::max(a, b)};
}

double badness(const Metric& metric, double value) {
  return metric.better == Better::larger ? -value : plotted_value(metric, value);
}

std::optional<std::pair<double, double>> badness_interval(const Metric& metric, const MeasuredError& error) {
  if (!error.low || !error.high) return std::nullopt;
  if (metric.better == Better::larger) return std::pair(-*error.high, -*error.low);
  return plotted_interval(metric, *error.low, *error.high);
}

double shown_value(const Metric& metric, const MeasuredError& error) {
  if (error.resolved || !error.low || !error.high) return error.value;
  if (higher_is_better(metric)) return *error.low;
  return metric.better == Better::nearer_to_zero ? std::max(std::abs(*error.low), std::abs(*error.high)) : *error.high;
}

double shown_badness(const Metric& metric, const MeasuredError& error) { return badness(metric, shown_value(metric, error)); }

ErrorKey usual_key() { return {Domain::surface, Component::indirect, headline_metric}; }

std::vector<ErrorKey> measured_keys(const Study& study) {
  std::set<ErrorKey> found;
  for (const StudyRun& run : study.runs)
    for (const auto& [key, error] : run.errors) found.insert(key);
  std::vector<ErrorKey> keys(found.begin(), found.end());
  std::vector<std::string> metrics{headline_metric};
  for (const Metric& metric : all_metrics()) metrics.push_back(metric.name);
  const auto order = [&metrics](const ErrorKey& key) {
    return std::tuple(position(std::vector{Domain::surface, Domain::image}, key.domain),
                      position(std::vector{Component::indirect, Component::total, Component::direct}, key.component),
                      position(metrics, key.metric), key);
  };
  std::sort(keys.begin(), keys.end(), [&order](const ErrorKey& a, const ErrorKey& b) { return order(a) < order(b); });
  return keys;
}

std::string describe(const ErrorKey& key) {
  const std::string component = to_string(key.component);
  return component + (key.domain == Domain::surface ? " irradiance at the surface samples" : " radiance in the camera image");
}

std::string axis_title(const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  if (metric.unit != MetricUnit::of_values) return metric.title;
  return metric.title + (key.domain == Domain::surface ? " (W/m²)" : " (W/(m² sr))");
}

}  // namespace gibench::report
