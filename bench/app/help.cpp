#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "bench/app/call_tree.h"
#include "bench/app/manual_page.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/record/machine.h"
#include "common/core/data_folder.h"
#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

struct HelpOptions {
  std::string verb;
  bool manual = false;
};

/// Where a page lies on this machine; its name in the sources if it was not installed.
std::string page_file(const std::string& page) {
  const fs::path data = data_folder();
  for (const fs::path& folder : {data, data.parent_path() / "doc" / "gibench"}) {
    std::error_code absent;
    if (fs::exists(folder / page, absent)) return (folder / page).string();
  }
  return page;
}

void print_pages(const CallTree& tree) {
  std::vector<std::string> pages;
  std::map<std::string, std::vector<std::string>> verbs;
  for (const CallVerb& verb : tree.verbs)
    for (const std::string& page : verb.pages) {
      if (verbs[page].empty()) pages.push_back(page);
      verbs[page].push_back(verb.name);
    }
  fmt::print("\nRead on\n");
  for (const std::string& page : pages) fmt::print("  {}  ({})\n", page_file(page), fmt::join(verbs[page], ", "));
}

void print_overview(const CallTree& tree) {
  fmt::print("{}\n\nUsage: {} VERB [OPTIONS]\n", tree.summary, tree.name);
  for (const std::string& group : tree.groups()) {
    fmt::print("\n{}\n", group);
    for (const CallVerb& verb : tree.verbs)
      if (verb.group == group) fmt::print("  {:<11} {}\n", verb.name, verb.summary);
  }
  std::vector<std::string> common;
  for (const CallOption& option : tree.verbs.front().options)
    if (option.is_common) common.push_back(option.names.back() + (option.value.empty() ? "" : " N"));
  fmt::print("\nEvery verb takes {}.\n{} help VERB lists the rest, {} help --man prints the manual page.\n",
             fmt::join(common, " "), tree.name, tree.name);
  print_pages(tree);
}

std::string help_of(const CLI::App& app, const std::string& name, const CallTree& tree) {
  if (!tree.find(name))
    throw InputError("help", fmt::format("there is no verb '{}'", name), known_names("verbs", name, tree.verb_names()));
  return app.get_subcommand(name)->help(app.get_name());
}

ExitStatus help(const HelpOptions& options, const CLI::App& app, bool json) {
  const CallTree tree = call_tree(app);
  if (options.manual && !options.verb.empty())
    throw InputError("--man", "there is one manual page for all verbs", "leave out the verb or --man");
  const std::string text = options.manual         ? manual_page(tree, version())
                           : options.verb.empty() ? std::string()
                                                  : help_of(app, options.verb, tree);
  if (json) print_json(text.empty() ? to_json(tree) : nlohmann::ordered_json{{"text", text}});
  else if (text.empty()) print_overview(tree);
  else fmt::print("{}", text);
  return ExitStatus::done;
}

}  // namespace

void add_help(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "help", "Says what there is, and what a verb takes");
  verb->group(verb_group::program);
  set_pages(*verb, {"docs/README.md", "docs/exit-status-and-environment.md"});
  const auto options = std::make_shared<HelpOptions>();
  verb->add_option("verb", options->verb, "The verb; without it all of them")->type_name(value_kind::verb);
  verb->add_flag("--man", options->manual, "The manual page, as troff");
  verb->callback(
      [&app, &call, options] { call.action = [&app, &call, options] { return help(*options, app, call.common.json); }; });
}

}  // namespace gibench
