/// The table of differences between runs of one scene.
#pragma once

#include "reports/collect/study.h"
#include "reports/tables/table.h"

namespace gibench::report {

/// Every two of the runs that were compared, and which of them is the better one where that is known.
Table pair_table(const Study& study, std::size_t scene, const ErrorKey& key);

}  // namespace gibench::report
