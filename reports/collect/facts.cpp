#include "reports/collect/facts.h"

#include <algorithm>

namespace gibench::report {
namespace {

void collect_facts(const Json& value, const std::string& path, Facts& facts) {
  if (value.is_null()) return;
  if (!value.is_object()) {
    facts.emplace_back(path, plain_text(value));
    return;
  }
  for (const auto& [name, child] : value.items()) collect_facts(child, path.empty() ? name : path + "." + name, facts);
}

}  // namespace

std::string plain_text(const Json& value) {
  const auto dumped = [](const Json& v) { return v.dump(-1, ' ', false, Json::error_handler_t::replace); };
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return dumped(value);
  if (std::any_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); })) return dumped(value);
  std::string joined;
  for (const Json& item : value) joined += (joined.empty() ? "" : ", ") + plain_text(item);
  return joined;
}

Facts facts_of(const Json& object, const std::vector<std::string>& without) {
  Facts facts;
  if (!object.is_object()) return facts;
  for (const auto& [name, value] : object.items())
    if (std::find(without.begin(), without.end(), name) == without.end()) collect_facts(value, name, facts);
  return facts;
}

}  // namespace gibench::report
