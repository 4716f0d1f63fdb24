/// The verbs and options of the program as data: help, shell completion and the manual page are made from it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gibench {

struct CallOption {
  std::vector<std::string> names;  ///< "-h", "--help"; of an argument without dashes its one name
  std::string value;               ///< the kind of value (value_kinds.h) or words with bars between; empty: a switch
  std::string range;               ///< "0 to 4096"; empty: any
  std::string default_value;       ///< empty: none
  std::string meaning;             ///< one line
  bool required = false, repeats = false, is_common = false;  ///< common: every verb has it

  bool is_argument() const { return names.front().front() != '-'; }
};

struct CallVerb {
  std::string name, summary, group;
  std::vector<std::string> pages;  ///< where to read on
  std::vector<CallOption> options;
};

struct CallTree {
  std::string name, summary;
  std::vector<CallOption> options;  ///< of the program itself
  std::vector<CallVerb> verbs;      ///< in their order in the help

  const CallVerb* find(const std::string& verb) const;
  std::vector<std::string> verb_names() const;
  /// The groups of verbs, in the order in which they first occur.
  std::vector<std::string> groups() const;
};

CallTree call_tree(const CLI::App& app);
nlohmann::ordered_json to_json(const CallTree& tree);

/// The help of a verb ends with these pages, and the overview lists them.
void set_pages(CLI::App& verb, const std::vector<std::string>& pages);

}  // namespace gibench
