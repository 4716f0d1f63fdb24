/// Lenient reading of manifests, which may lack entries; nlohmann/json stays out of the other headers.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/json_fields.h"
#include "reports/collect/study.h"

namespace gibench::report {

using Json = nlohmann::ordered_json;

/// The entry as text, number or list of texts; empty where it is absent, null or of another type.
std::optional<std::string> text_at(const Json& object, const std::string& name);
std::optional<double> number_at(const Json& object, const std::string& name);
std::optional<std::uint64_t> count_at(const Json& object, const std::string& name);

/// The entry; an empty object where it is absent or not an object.
const Json& object_at(const Json& object, const std::string& name);

/// A scalar as it is written, a list of scalars joined by commas; anything else as JSON.
std::string plain_text(const Json& value);

/// Every scalar under `object` by its path: {"a": {"b": 1}} gives a.b = 1. Names in `without` are left out at the top.
Facts facts_of(const Json& object, const std::vector<std::string>& without = {});

}  // namespace gibench::report
