#include "bench/app/call_tree.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace gibench {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* read_on = "Read on: ";

/// "INT in [0 - 4096]" as "0 to 4096"; nothing for other descriptions of a check.
std::string range_of(const std::string& check) {
  const std::size_t begin = check.find('['), end = check.find(']');
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::string range = check.substr(begin + 1, end - begin - 1);
  if (const std::size_t dash = range.find(" - "); dash != std::string::npos) range.replace(dash, 3, " to ");
  return range;
}

CallOption describe(const CLI::Option& option) {
  CallOption described;
  if (option.get_positional()) described.names = {option.get_name(true, false)};
  else {
    for (const std::string& name : option.get_snames()) described.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) described.names.push_back("--" + name);
  }
  const std::string type = option.get_items_expected_max() == 0 ? std::string() : option.get_type_name();
  const std::size_t colon = type.find(':');
  described.value = type.substr(0, colon);
  if (colon != std::string::npos) described.range = range_of(type.substr(colon + 1));
  described.default_value = option.get_default_str();
  described.meaning = option.get_description();
  described.required = option.get_required();
  described.repeats = option.get_expected_max() > 1;
  return described;
}

std::vector<CallOption> options_of(const CLI::App& app) {
  std::vector<CallOption> options;
  for (const CLI::Option* option : app.get_options()) options.push_back(describe(*option));
  return options;
}

void mark_common(std::vector<CallVerb>& verbs) {
  const auto has = [](const CallVerb& verb, const CallOption& option) {
    return std::any_of(verb.options.begin(), verb.options.end(),
                       [&](const CallOption& other) { return other.names == option.names && other.meaning == option.meaning; });
  };
  for (CallVerb& verb : verbs)
    for (CallOption& option : verb.options)
      option.is_common = std::all_of(verbs.begin(), verbs.end(), [&](const CallVerb& other) { return has(other, option); });
}

Json option_json(const CallOption& option) {
  Json json{{"names", option.names}, {"meaning", option.meaning}};
  if (!option.value.empty()) json["value"] = option.value;
  if (!option.range.empty()) json["range"] = option.range;
  if (!option.default_value.empty()) json["default"] = option.default_value;
  json["required"] = option.required, json["repeats"] = option.repeats;
  return json;
}

Json options_json(const std::vector<CallOption>& options) {
  Json list = Json::array();
  for (const CallOption& option : options) list.push_back(option_json(option));
  return list;
}

}  // namespace

const CallVerb* CallTree::find(const std::string& verb) const {
  const auto found = std::find_if(verbs.begin(), verbs.end(), [&](const CallVerb& known) { return known.name == verb; });
  return found == verbs.end() ? nullptr : &*found;
}

std::vector<std::string> CallTree::verb_names() const {
  std::vector<std::string> names;
  for (const CallVerb& verb : verbs) names.push_back(verb.name);
  return names;
}

std::vector<std::string> CallTree::groups() const {
  std::vector<std::string> groups;
  for (const CallVerb& verb : verbs)
    if (std::find(groups.begin(), groups.end(), verb.group) == groups.end()) groups.push_back(verb.group);
  return groups;
}

CallTree call_tree(const CLI::App& app) {
  CallTree tree{app.get_name(), app.get_description(), options_of(app), {}};
  for (const CLI::App* verb : app.get_subcommands({})) {
    CallVerb described{verb->get_name(), verb->get_description(), verb->get_group(), {}, options_of(*verb)};
    if (const std::string footer = verb->get_footer(); footer.starts_with(read_on))
      for (const std::string& page : CLI::detail::split(footer.substr(std::string(read_on).size()), ','))
        described.pages.push_back(CLI::detail::trim_copy(page));
    tree.verbs.push_back(std::move(described));
  }
  mark_common(tree.verbs);
  return tree;
}

Json to_json(const CallTree& tree) {
  Json verbs = Json::array();
  for (const CallVerb& verb : tree.verbs)
    verbs.push_back({{"name", verb.name},
                     {"summary", verb.summary},
                     {"group", verb.group},
                     {"read_on", verb.pages},
                     {"options", options_json(verb.options)}});
  return {{"name", tree.name}, {"summary", tree.summary}, {"options", options_json(tree.options)}, {"verbs", std::move(verbs)}};
}

void set_pages(CLI::App& verb, const std::vector<std::string>& pages) {
  verb.footer(fmt::format("{}{}", read_on, fmt::join(pages, ", ")));
}

}  // namespace gibench
