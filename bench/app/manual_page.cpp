#include "bench/app/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace gibench {

namespace {

/// The code point that starts at text[i], which is moved to its last byte. Text that is not UTF-8 is taken byte by byte.
unsigned code_point(std::string_view text, std::size_t& i) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])); };
  const unsigned first = byte(i);
  const std::size_t more = first >= 0xF0U ? 3 : first >= 0xE0U ? 2 : first >= 0xC0U ? 1 : 0;
  if (more == 0 || i + more >= text.size()) return first;
  unsigned point = first & (0x3FU >> more);
  for (std::size_t k = 1; k <= more; ++k) point = (point << 6U) | (byte(++i) & 0x3FU);
  return point;
}

/// Text as troff takes it literally.
std::string escaped(std::string_view text) {
  std::string page;
  if (!text.empty() && (text.front() == '.' || text.front() == '\'')) page = "\\&";
  for (std::size_t i = 0; i < text.size(); ++i) {
    switch (text[i]) {
      case '\\': page += "\\e"; break;
      case '-': page += "\\-"; break;
      case '\'': page += "\\(aq"; break;
      case '^': page += "\\(ha"; break;
      case '~': page += "\\(ti"; break;
      case '`': page += "\\(ga"; break;
      default:
        if (static_cast<unsigned char>(text[i]) < 0x80U) page += text[i];
        else page += fmt::format("\\[u{:04X}]", code_point(text, i));
    }
  }
  return page;
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }

/// Words that are meant literally stand bold, kinds of values in italics.
std::string value_of(const CallOption& option) {
  std::string text;
  std::string_view rest = option.value;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find('|'));
    const bool is_kind = word.find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string_view::npos;
    text += (text.empty() ? "" : "|") + (is_kind ? "\\fI" + escaped(word) + "\\fR" : bold(word));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
  }
  return text;
}

std::string names_of(const CallOption& option) {
  if (option.is_argument()) return "\\fI" + escaped(option.names.front()) + "\\fR";
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + bold(name);
  return option.value.empty() ? text : text + " " + value_of(option);
}

std::string option_entry(const CallOption& option) {
  std::vector<std::string> facts;
  if (option.is_argument() && option.value.find('|') != std::string::npos) facts.push_back("one of " + value_of(option));
  if (!option.range.empty()) facts.push_back(escaped(option.range));
  if (!option.default_value.empty()) facts.push_back("default " + escaped(option.default_value));
  if (option.required && !option.is_argument()) facts.emplace_back("required");
  const std::string more = facts.empty() ? "" : fmt::format(" ({})", fmt::join(facts, "; "));
  return fmt::format(".TP\n{}\n{}{}\n", names_of(option), escaped(option.meaning), more);
}

/// "gibench run scene --method METHOD [OPTIONS]".
std::string usage_of(const CallTree& tree, const CallVerb& verb) {
  std::string text = bold(tree.name + " " + verb.name);
  for (const CallOption& option : verb.options) {
    if (!option.is_argument()) continue;
    text += option.required ? " " + names_of(option) : " [" + names_of(option) + "]";
  }
  for (const CallOption& option : verb.options)
    if (option.required && !option.is_argument()) text += " " + names_of(option);
  return text + " [\\fIOPTIONS\\fR]";
}

std::string verb_entry(const CallTree& tree, const CallVerb& verb) {
  std::string page = fmt::format(".SS {}\n{}.\n", usage_of(tree, verb), escaped(verb.summary));
  for (const CallOption& option : verb.options)
    if (!option.is_common) page += option_entry(option);
  if (!verb.pages.empty()) page += fmt::format(".PP\nRead on: {}.\n", escaped(fmt::format("{}", fmt::join(verb.pages, ", "))));
  return page;
}

std::string overview(const CallTree& tree) {
  std::string page;
  for (const std::string& group : tree.groups()) {
    page += fmt::format(".PP\n{}:\n", escaped(group));
    for (const CallVerb& verb : tree.verbs)
      if (verb.group == group) page += fmt::format(".TP\n{}\n{}.\n", bold(verb.name), escaped(verb.summary));
  }
  return page;
}

std::string common_options(const CallTree& tree) {
  std::string page = ".SH OPTIONS OF EVERY VERB\n";
  if (!tree.verbs.empty())
    for (const CallOption& option : tree.verbs.front().options)
      if (option.is_common) page += option_entry(option);
  page += ".SH OPTIONS OF THE PROGRAM\n";
  for (const CallOption& option : tree.options) page += option_entry(option);
  return page;
}

constexpr const char* closing = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
A gate failed.
.TP
.B 2
The input or the call is wrong: one line on stderr says what is wrong, where, and how to fix it.
.TP
.B 3
Inconclusive.
.TP
.B 4
The work itself failed: out of time or memory, no convergence, a method that refused the scene, cancelled.
.SH ENVIRONMENT
.TP
.B GIBENCH_PATH
Folders, colons between, in which relative files are looked up after the folder of the scene.
.TP
.B GIBENCH_DATA
The folder with scenes, schemas and the files of the report, in place of \fI../share/gibench\fR beside the program.
.TP
.B GIBENCH_REPORTS
The folder with the page, the plot templates and their npm packages, in place of \fIreports/\fR in the data folder.
.TP
.B GIBENCH_CHROMIUM
The Chromium that prints plots as PDF where \fBrsvg-convert\fR is not installed.
.SH FILES
.TP
.I references/
The store of references in the working folder; \fB\-\-references\fR names another one.
.TP
.I share/gibench/scenes/
Scenes, their schema and studies, known by name.
.TP
.I share/doc/gibench/docs/
The pages named above: one's own scene from file to report, choosing a method, reading errors, queries, files.
.SH EXAMPLES
.nf
gibench check cornell\-box
gibench reference cornell\-box \-\-target\-error 0.02
gibench run cornell\-box \-\-method meshless \-\-set epsilon_E=0.08 \-\-out out/box
gibench study quick \-\-out out/quick
gibench report out/quick
.fi
)";

}  // namespace

std::string manual_page(const CallTree& tree, const std::string& version) {
  std::string page = fmt::format(".TH GIBENCH 1 \"\" \"gibench {}\" \"User Commands\"\n", escaped(version));
  page += fmt::format(".SH NAME\n{} \\- {}\n", escaped(tree.name), escaped(tree.summary));
  page += fmt::format(".SH SYNOPSIS\n{} \\fIVERB\\fR [\\fIOPTIONS\\fR]\n", bold(tree.name));
  page +=
      ".SH DESCRIPTION\nRuns finite\\-element and precomputed light\\-transport methods on the same scene, through one "
      "interface, and "
      "compares each\nwith a path\\-traced reference whose own uncertainty is known. The same seed gives the same bits for any "
      "number of threads.\n";
  page += overview(tree);
  page += ".SH VERBS\n";
  for (const CallVerb& verb : tree.verbs) page += verb_entry(tree, verb);
  page += common_options(tree);
  return page + closing;
}

}  // namespace gibench
