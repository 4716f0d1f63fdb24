#include "common/method/answer_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/core/error.h"

namespace gibench {

namespace {

void check_written(std::span<const Rgb> values, const char* what, StageReport& report) {
  if (!succeeded(report.termination)) return;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_finite(values[i])) {
      report.termination = Termination::invalid_output;
      report.message = fmt::format("{} of sample {} was not written or is not finite", what, i);
      return;
    }
}

}  // namespace

void check_sizes(const ShadeRequest& request, const ShadeAnswer& answer) {
  const std::size_t count = request.samples.size();
  const auto fits = [&](std::span<const Rgb> values) { return values.empty() || values.size() == count; };
  GIBENCH_CHECK(fits(answer.direct) && fits(answer.indirect), "one value for each sample");
  GIBENCH_CHECK(fits(answer.direct_variance) && fits(answer.indirect_variance) && fits(answer.total_variance),
                "one variance for each sample");
  GIBENCH_CHECK(request.toward_viewer.size() == (request.quantity == Quantity::radiance ? count : 0),
                "one direction for each sample where radiance is asked for");
}

void fill_with_nan(const ShadeAnswer& answer) {
  for (const std::span<Rgb> values :
       {answer.direct, answer.indirect, answer.direct_variance, answer.indirect_variance, answer.total_variance})
    std::fill(values.begin(), values.end(), Rgb(std::numeric_limits<float>::quiet_NaN()));
}

void check_written(const ShadeAnswer& answer, StageReport& report) {
  check_written(answer.direct, "direct light", report);
  check_written(answer.indirect, "indirect light", report);
  for (const std::span<const Rgb> variance : {answer.direct_variance, answer.indirect_variance, answer.total_variance})
    check_written(variance, "the variance", report);
}

}  // namespace gibench
