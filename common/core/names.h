/// Names in messages: quoted, listed, and the nearest one to what was written.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace gibench {

/// "name" in quotes.
std::string in_quotes(std::string_view name);

/// What to write instead of `unknown`: `did you mean "floor"? ` where a known name is near, then the known
/// names (the first twenty), as `kind: a, b, c`, or `there are no KIND` where there are none.
std::string known_names(std::string_view kind, std::string_view unknown, const std::vector<std::string>& known);

/// Makes names that are all different.
class UniqueNames {
 public:
  /// `name`, or the first of name#2, name#3, … that was not taken before.
  std::string take(const std::string& name);

 private:
  std::unordered_map<std::string, int> times_taken_;
};

}  // namespace gibench
