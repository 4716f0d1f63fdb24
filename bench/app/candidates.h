/// The words that may stand next in a call that is being typed: what shell completion offers.
#pragma once

#include <string>
#include <vector>

#include "bench/app/call_tree.h"

namespace gibench {

struct Candidate {
  std::string word;     ///< in full, the part that is typed already included
  std::string meaning;  ///< one line; may be empty
};

enum class Paths { none, folders, files };

struct Candidates {
  std::vector<Candidate> words;
  Paths paths = Paths::none;  ///< what of the file system fits as well: for the shell, which knows it best
};

/// `words` are those after the program's name; the last one, which may be empty, is the one to complete.
Candidates candidates_for(const CallTree& tree, const std::vector<std::string>& words);

}  // namespace gibench
