/// The lines of a text file as people and programs write them, and the words and numbers in them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace gibench {

/// Walks over the statements of a text: lines joined where one ends in a backslash, without comment lines (which begin with
/// `#` and end with their line, whatever stands last in it), empty lines, blanks around them and line ends of any system.
class TextLines {
 public:
  explicit TextLines(std::string_view text);

  /// Goes to the next statement; false where there is none.
  bool next();

  std::string_view line() const { return line_; }  ///< valid until next()
  std::size_t number() const { return number_; }   ///< of its first line, from 1
  bool is_unended() const { return is_unended_; }  ///< the text ends with this line, without a line end

 private:
  std::string_view take_line();

  std::string_view rest_, line_;
  std::string joined_;
  char line_end_;
  std::size_t number_ = 0, lines_taken_ = 0;
  bool is_unended_ = false;
};

/// Without the blanks and line ends around it.
std::string_view trimmed(std::string_view text);

/// Takes the first word off a line without blanks in front; empty at its end.
std::string_view take_word(std::string_view& line);

/// The number that a word is, as C writes numbers, also with a plus sign in front; empty for any other word.
/// One too large for double precision is infinite, one too small is 0.
std::optional<double> to_number(std::string_view word);

/// In lower case (ASCII).
std::string lower_case(std::string_view text);

/// The beginning of a text in quotes, for messages.
std::string excerpt(std::string_view text);

/// The first ten of them, and how many more there are.
std::string few_of(const std::set<std::string>& names);

}  // namespace gibench
