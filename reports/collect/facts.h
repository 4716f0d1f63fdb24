/// Names and values of a record as texts; nlohmann/json stays out of the other headers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/record/json_fields.h"
#include "reports/collect/study.h"

namespace gibench::report {

using Json = nlohmann::ordered_json;

/// A scalar as it is written, a list of scalars joined by commas; anything else as JSON.
std::string plain_text(const Json& value);

/// Every scalar under `object` by its path: {"a": {"b": 1}} gives a.b = 1. Names in `without` are left out at the top.
Facts facts_of(const Json& object, const std::vector<std::string>& without = {});

}  // namespace gibench::report
