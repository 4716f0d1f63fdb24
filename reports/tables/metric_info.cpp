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

double badness(const Metric& metric, double value) {
  return metric.better == Better::larger ? -value : plotted_value(metric, value);
}

ErrorKey usual_key() { return {"surface", "indirect", headline_metric}; }

std::vector<ErrorKey> measured_keys(const Study& study) {
  std::set<ErrorKey> found;
  for (const StudyRun& run : study.runs)
    for (const auto& [key, error] : run.errors) found.insert(key);
  std::vector<ErrorKey> keys(found.begin(), found.end());
  std::vector<std::string> metrics{headline_metric};
  for (const Metric& metric : all_metrics()) metrics.push_back(metric.name);
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
  const Metric metric = metric_info(key.metric);
  if (metric.unit != MetricUnit::of_values) return metric.title;
  return metric.title + (key.domain == "surface" ? " (W/m²)" : " (W/(m² sr))");
}

}  // namespace gibench::report
