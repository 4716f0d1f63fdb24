/// One recorded error as tables take it.
#pragma once

#include "bench/record/run_record.h"
#include "reports/collect/study.h"

namespace gibench::report {

MeasuredError measured(const ErrorValue& recorded);

}  // namespace gibench::report
