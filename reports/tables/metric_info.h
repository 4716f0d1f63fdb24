/// The way each metric is plotted and compared, and the errors that a study has.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/metrics/metric_table.h"
#include "reports/collect/study.h"

namespace gibench::report {

/// The one of the table, or a plain description of a metric that is not in it.
Metric metric_info(const std::string& name);

bool is_percentage(const Metric& metric);
/// Whether its error axis is.
bool is_logarithmic(const Metric& metric);
bool higher_is_better(const Metric& metric);

/// The number drawn on the error axis.
double plotted_value(const Metric& metric, double value);
/// Smallest and largest of the numbers drawn for the values of an interval: one around "no error" begins at it.
std::pair<double, double> plotted_interval(const Metric& metric, double low, double high);
/// A number that is smaller for a better result.
double badness(const Metric& metric, double value);
/// Smallest and largest badness of the error's 95% interval; empty for an error without one.
std::optional<std::pair<double, double>> badness_interval(const Metric& metric, const MeasuredError& error);
/// The value of a resolved error; of another the end of its interval that is farthest from "no error": it may be as large.
double shown_value(const Metric& metric, const MeasuredError& error);
/// The badness of the value that is shown: what runs are ordered by.
double shown_badness(const Metric& metric, const MeasuredError& error);

/// The error that a report shows where none was measured.
ErrorKey usual_key();
/// Every combination that some run measured, in the order in which it is offered: surface before image, indirect before
/// total before direct, the headline metric before the others as in all_metrics(). The first is the report's default.
std::vector<ErrorKey> measured_keys(const Study& study);

/// What an error is an error of: "indirect irradiance at the surface samples".
std::string describe(const ErrorKey& key);
/// The metric's title with its unit.
std::string axis_title(const ErrorKey& key);

}  // namespace gibench::report
