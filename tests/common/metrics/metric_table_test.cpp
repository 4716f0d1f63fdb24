#include "common/metrics/metric_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace gibench {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out;
}

/// The rows of README's table of metrics.
std::vector<std::string> readme_rows() {
  std::ifstream file(std::string(GIBENCH_SOURCE_DIR) + "/README.md");
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("| name | definition")) inside = true;
    else if (!line.starts_with("|")) inside = false;
    else if (inside && line != "|---|---|") rows.push_back(line);
  }
  return rows;
}

TEST(MetricTable, TheReadmeSaysTheSame) {
  std::vector<std::string> rows;
  for (const Metric& metric : all_metrics()) rows.push_back("| `" + metric.name + "` | " + escaped(metric.meaning) + " |");
  EXPECT_EQ(readme_rows(), rows);
}

TEST(MetricTable, EveryRowIsFoundByItsNameAndWhole) {
  std::set<std::string> names, titles;
  for (const Metric& metric : all_metrics()) {
    EXPECT_EQ(find_metric(metric.name), &metric);
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_TRUE(titles.insert(metric.title).second) << metric.title;
    EXPECT_FALSE(metric.meaning.empty()) << metric.name;
    EXPECT_NE(metric.better, Better::unknown) << metric.name;
    if (const auto* of_values = value_metric(metric)) EXPECT_NE(of_values->estimate, nullptr) << metric.name;
    else EXPECT_NE(std::get<PictureMetric>(metric.function).error, nullptr) << metric.name;
  }
  EXPECT_NE(find_metric(headline_metric), nullptr);
  EXPECT_EQ(find_metric("rmse "), nullptr);
}

}  // namespace
}  // namespace gibench
