#include "common/json/schema_nodes.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "common/core/names.h"
#include "common/json/schema_validation.h"

namespace gibench {

namespace {

using nlohmann::json;

void gather(const json& root, const json& schema, const json& value, SchemaNodes& nodes) {
  nodes.push_back(&schema);
  if (const auto reference = schema.find("$ref"); reference != schema.end())
    gather(root, root.at(json::json_pointer(reference->get_ref<const std::string&>().substr(1))), value, nodes);
  if (const auto all = schema.find("allOf"); all != schema.end())
    for (const json& part : *all) gather(root, part, value, nodes);
  if (const auto condition = schema.find("if"); condition != schema.end())
    if (const auto branch = schema.find(holds(*condition, value) ? "then" : "else"); branch != schema.end())
      gather(root, *branch, value, nodes);
}

bool has_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

bool has_listed_type(const json& value, const json& types) {
  if (types.is_string()) return has_type(value, types.get<std::string>());
  for (const json& type : types)
    if (has_type(value, type.get<std::string>())) return true;
  return false;
}

/// A value as it stands in a message, shortened.
std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > 40) text = text.substr(0, 37) + "...";
  return text;
}

/// The bound that a number breaks, in words; empty where it keeps all.
std::string broken_bound(const json& node, const json& value) {
  struct Bound {
    std::string_view keyword, words;
    bool (*kept)(double, double);
  };
  static constexpr Bound bounds[] = {
      {"minimum", " is below ", [](double x, double bound) { return x >= bound; }},
      {"maximum", " is above ", [](double x, double bound) { return x <= bound; }},
      {"exclusiveMinimum", " is not above ", [](double x, double bound) { return x > bound; }},
      {"exclusiveMaximum", " is not below ", [](double x, double bound) { return x < bound; }},
  };
  for (const Bound& bound : bounds)
    if (const auto limit = node.find(bound.keyword); limit != node.end())
      if (!bound.kept(value.get<double>(), limit->get<double>())) return shown(value) + std::string(bound.words) + limit->dump();
  return {};
}

std::string broken_length(const json& node, const json& value) {
  const auto broken = [&](std::string_view keyword, bool (*kept)(std::size_t, std::size_t)) {
    const auto limit = node.find(keyword);
    return limit != node.end() && !kept(value.size(), limit->get<std::size_t>());
  };
  const auto at_least = [](std::size_t size, std::size_t limit) { return size >= limit; };
  const auto at_most = [](std::size_t size, std::size_t limit) { return size <= limit; };
  if (value.is_array() && (broken("minItems", at_least) || broken("maxItems", at_most)))
    return "a list of " + std::to_string(value.size()) + (value.size() == 1 ? " value" : " values");
  if (value.is_string() && value.get_ref<const std::string&>().empty() && node.value("minLength", 0) > 0)
    return "the text is empty";
  return {};
}

/// What breaks a rule of this node alone; empty where nothing does.
std::string broken_value_rule(const json& node, const json& value) {
  if (const auto types = node.find("type"); types != node.end() && !has_listed_type(value, *types))
    return shown(value) + " is of the wrong type";
  if (const auto expected = node.find("const"); expected != node.end() && value != *expected)
    return shown(value) + " is not " + expected->dump();
  if (const auto choices = node.find("enum"); choices != node.end())
    if (std::find(choices->begin(), choices->end(), value) == choices->end()) return shown(value) + " is not known here";
  return value.is_number() ? broken_bound(node, value) : broken_length(node, value);
}

/// What the schema says that belongs there.
std::string remedy_of(const SchemaNodes& nodes) {
  for (const json* node : nodes)
    if (const auto description = node->find("description"); description != node->end())
      return "give " + description->get<std::string>();
  return {};
}

std::optional<BrokenRule> broken_key_rule(const json& root, const SchemaNodes& nodes, const json& value) {
  for (const json* node : nodes) {
    if (const auto others = node->find("additionalProperties"); others == node->end() || *others != json(false)) continue;
    const json& known = node->at("properties");
    for (const auto& [key, ignored] : value.items()) {
      if (known.contains(key)) continue;
      std::vector<std::string> names;
      for (const auto& [name, schema] : known.items()) names.push_back(name);
      return BrokenRule{"unknown key " + in_quotes(key), known_names("known keys", key, names)};
    }
  }
  for (const json* node : nodes) {
    const auto required = node->find("required");
    if (required == node->end()) continue;
    for (const json& key : *required)
      if (const auto name = key.get<std::string>(); !value.contains(name))
        return BrokenRule{"the key " + in_quotes(name) + " is missing", remedy_of(nodes_of_element(root, nodes, name, json()))};
  }
  return std::nullopt;
}

}  // namespace

SchemaNodes applicable_nodes(const json& root, const json& schema, const json& value) {
  SchemaNodes nodes;
  gather(root, schema, value, nodes);
  return nodes;
}

SchemaNodes nodes_of_element(const json& root, const SchemaNodes& nodes, const std::string& key, const json& element) {
  SchemaNodes found;
  for (const json* node : nodes) {
    const json* schema = nullptr;
    if (key.empty()) {
      if (const auto items = node->find("items"); items != node->end()) schema = &*items;
    } else {
      const auto properties = node->find("properties");
      const auto others = node->find("additionalProperties");
      if (properties != node->end() && properties->contains(key)) schema = &properties->at(key);
      else if (others != node->end() && others->is_object()) schema = &*others;
    }
    if (schema != nullptr) gather(root, *schema, element, found);
  }
  return found;
}

std::optional<BrokenRule> broken_rule(const json& root, const SchemaNodes& nodes, const json& value) {
  for (const json* node : nodes)
    if (const std::string problem = broken_value_rule(*node, value); !problem.empty())
      return BrokenRule{problem, remedy_of(nodes)};
  return value.is_object() ? broken_key_rule(root, nodes, value) : std::nullopt;
}

}  // namespace gibench
