#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/candidates.h"
#include "bench/app/completion_scripts.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"

namespace gibench {

namespace {

struct CompletionOptions {
  std::string what;
  std::vector<std::string> words;
};

const char* script_for(const std::string& shell) {
  if (shell == "bash") return bash_completion();
  return shell == "zsh" ? zsh_completion() : fish_completion();
}

/// What the file system adds, as the scripts read it: no word of the program starts with a colon.
const char* marker_of(Paths paths) {
  switch (paths) {
    case Paths::none: return "";
    case Paths::folders: return ":folders";
    case Paths::files: return ":files";
  }
  return "";
}

ExitStatus print_candidates(const Candidates& found, bool json) {
  const std::string marker = marker_of(found.paths);
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Candidate& candidate : found.words) list.push_back({{"word", candidate.word}, {"meaning", candidate.meaning}});
    print_json({{"words", std::move(list)}, {"files", found.paths == Paths::files}, {"folders", found.paths != Paths::none}});
    return ExitStatus::done;
  }
  for (const Candidate& candidate : found.words) fmt::print("{}\t{}\n", candidate.word, candidate.meaning);
  if (!marker.empty()) fmt::print("{}\n", marker);
  return ExitStatus::done;
}

ExitStatus completion(const CompletionOptions& options, const CLI::App& app, bool json) {
  if (options.what == "words") return print_candidates(candidates_for(call_tree(app), options.words), json);
  const std::string script = script_for(options.what);
  if (json) print_json({{"script", script}});
  else fmt::print("{}", script);
  return ExitStatus::done;
}

}  // namespace

void add_completion(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "completion", "Prints the script by which a shell completes calls of gibench");
  verb->group(verb_group::program);
  set_pages(*verb, {"docs/shell.md"});
  const auto options = std::make_shared<CompletionOptions>();
  take_one_of(verb->add_option("what", options->what, "The shell; or words: what may stand next after the words that follow"),
              {"bash", "zsh", "fish", "words"})
      ->required();
  verb->add_option("words", options->words, "A call as far as it is typed, after --; its last word is the one to complete");
  verb->callback(
      [&app, &call, options] { call.action = [&app, &call, options] { return completion(*options, app, call.common.json); }; });
}

}  // namespace gibench
