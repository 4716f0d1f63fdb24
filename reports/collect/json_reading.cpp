#include "reports/collect/json_reading.h"

#include <algorithm>
#include <cmath>

namespace gibench::report {
namespace {

const Json* entry(const Json& object, const std::string& name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

void collect_facts(const Json& value, const std::string& path, Facts& facts) {
  if (value.is_null()) return;
  if (!value.is_object()) {
    facts.emplace_back(path, plain_text(value));
    return;
  }
  for (const auto& [name, child] : value.items()) collect_facts(child, path.empty() ? name : path + "." + name, facts);
}

}  // namespace

std::optional<std::string> text_at(const Json& object, const std::string& name) {
  const Json* value = entry(object, name);
  return value && value->is_string() ? std::optional(value->get<std::string>()) : std::nullopt;
}

std::optional<double> number_at(const Json& object, const std::string& name) {
  const Json* value = entry(object, name);
  if (!value || !value->is_number()) return std::nullopt;
  const double number = value->get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<std::uint64_t> count_at(const Json& object, const std::string& name) {
  const Json* value = entry(object, name);
  if (!value || !value->is_number_integer()) return std::nullopt;
  if (value->is_number_unsigned()) return value->get<std::uint64_t>();
  const auto number = value->get<std::int64_t>();
  return number < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(number));
}

const Json& object_at(const Json& object, const std::string& name) {
  static const Json nothing = Json::object();
  const Json* value = entry(object, name);
  return value && value->is_object() ? *value : nothing;
}

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
