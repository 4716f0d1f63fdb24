#include "pinned_runs.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/core/error.h"

namespace gibench::truth {

namespace {

std::optional<int> cell_of(const std::string& text) {
  if (text == "-") return std::nullopt;
  if (text == "no") return 0;
  return std::stoi(text);
}

/// Lines "column LETTER RULE" come first, then "case LETTER LETTER …", then a line for each case. "#" begins a comment.
PinnedRuns read_table() {
  std::ifstream file(std::filesystem::path(GIBENCH_TEST_DATA) / "runs.txt");
  PinnedRuns runs;
  std::map<std::string, std::string> rules;
  std::vector<std::string> columns;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string first, word;
    if (!(words >> first)) continue;
    if (first == "column") {
      words >> word;
      words >> rules[word];
      runs[rules[word]];
      continue;
    }
    std::size_t column = 0;
    for (; words >> word; ++column)
      if (first == "case") columns.push_back(rules.at(word));
      else runs.at(columns.at(column))[first] = cell_of(word);
    if (column != rules.size()) throw WorkError("runs.txt: the line of " + first + " has another number of columns");
  }
  return runs;
}

}  // namespace

const PinnedRuns& pinned_runs() {
  static const PinnedRuns runs = read_table();
  return runs;
}

}  // namespace gibench::truth
