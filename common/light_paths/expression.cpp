#include "common/light_paths/expression.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

#include "common/core/error.h"

namespace gibench {

namespace {

constexpr int deepest = 100;           // brackets inside one another
constexpr int most_operators = 10;     // *, + and {m,n} after one another: with the brackets, they bound recursion
constexpr int largest_count = 100000;  // of {m,n}

constexpr PathEvents of_kind(PathEvent reflection, PathEvent transmission) { return PathEvents(reflection) | transmission; }

/// The events that a single letter stands for; empty: none.
PathEvents events_of(char letter) {
  switch (letter) {
    case 'C': return PathEvent::camera;
    case 'R': return reflections;
    case 'T': return transmissions;
    case 'D': return of_kind(PathEvent::diffuse_reflection, PathEvent::diffuse_transmission);
    case 'G': return of_kind(PathEvent::glossy_reflection, PathEvent::glossy_transmission);
    case 'S': return of_kind(PathEvent::mirror_reflection, PathEvent::mirror_transmission);
    case 'L': return PathEvent::light;
    case 'O': return PathEvent::emitter;
    case 'B': return PathEvent::background;
    case '.': return every_event;
    default: return {};
  }
}

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  PathNode parse() {
    PathNode root = choice();
    if (!at_end()) fail(next() == ')' ? "the end: no '(' is open" : "an event, an operator or the end");
    return root;
  }

 private:
  static constexpr const char* an_event = "an event (C R T D G S L O B . < [ or a part in brackets)";

  void skip_spaces() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool at_end() {
    skip_spaces();
    return at_ == text_.size();
  }
  char next() { return at_end() ? '\0' : text_[at_]; }
  bool take(char c) {
    if (next() != c || at_end()) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const std::string& expected) {
    const bool printable = !at_end() && std::isprint(static_cast<unsigned char>(text_[at_])) != 0;
    const std::string found = at_end()    ? std::string("the end")
                              : printable ? fmt::format("'{}'", text_[at_])
                                          : std::string("no letter of the syntax");
    throw InputError(place_of_light_paths(text_), fmt::format("{} at position {}", found, at_ + 1), "expected " + expected);
  }

  void enter() {
    if (++depth_ > deepest) fail(fmt::format("at most {} brackets inside one another", deepest));
  }

  PathNode choice() {
    enter();
    PathNode node{PathNode::Kind::choice, {}, {}, 0, {}};
    do node.children.push_back(sequence());
    while (take('|'));
    --depth_;
    return node.children.size() == 1 ? PathNode(std::move(node.children.front())) : node;
  }

  PathNode sequence() {
    PathNode node{PathNode::Kind::sequence, {}, {}, 0, {}};
    do node.children.push_back(repeated());
    while (!at_end() && next() != '|' && next() != ')');
    return node.children.size() == 1 ? PathNode(std::move(node.children.front())) : node;
  }

  PathNode repeated() {
    PathNode node = single();
    for (int operators = 1;; ++operators) {
      int least = 0;
      std::optional<int> most;
      if (take('+')) least = 1;
      else if (take('{')) counts(least, most);
      else if (!take('*')) return node;
      if (operators > most_operators) {
        --at_;
        fail(fmt::format("at most {} operators after one another", most_operators));
      }
      PathNode repeat{PathNode::Kind::repeat, {}, {}, least, most};
      repeat.children.push_back(std::move(node));
      node = std::move(repeat);
    }
  }

  /// After '{': m,n} or m,} or n}.
  void counts(int& least, std::optional<int>& most) {
    least = count();
    const bool exactly = !take(',');
    if (exactly) most = least;
    else if (next() != '}') most = count();
    if (most && *most < least) {
      --at_;
      fail(fmt::format("a count of at least {}", least));
    }
    if (!take('}')) fail(exactly ? "',' or '}'" : "'}'");
  }

  int count() {
    if (std::isdigit(static_cast<unsigned char>(next())) == 0) fail("a count");
    int value = 0;
    for (; at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0; ++at_) {
      value = 10 * value + (text_[at_] - '0');
      if (value > largest_count) fail(fmt::format("a count of at most {}", largest_count));
    }
    return value;
  }

  PathNode single() {
    if (!take('(')) return {PathNode::Kind::event, event(an_event), {}, 0, {}};
    PathNode inner = choice();
    if (!take(')')) fail("')', '|', an operator or an event");
    return inner;
  }

  /// A letter, <…> or […].
  PathEvents event(const std::string& expected) {
    if (take('<')) return type_and_kind();
    if (take('[')) return group("an event of the group or ']'", [this](const std::string& what) { return event(what); });
    const PathEvents events = events_of(next());
    if (events.empty()) fail(next() == '?' ? std::string(an_event) + "; what may be missing is written {0,1}" : expected);
    ++at_;
    return events;
  }

  /// After '[': any of the members, or any but those. `member` parses one.
  template <class Member>
  PathEvents group(const std::string& expected, const Member& member) {
    enter();
    const bool others = take('^');
    PathEvents events;
    do events |= member(expected);
    while (!take(']'));
    --depth_;
    return others ? ~events : events;
  }

  PathEvents letter_of(std::string_view letters, const std::string& expected) {
    const char letter = next();
    if (at_end() || letters.find(letter) == std::string_view::npos) fail(expected);
    ++at_;
    return events_of(letter);
  }

  /// One place of <…>: a letter of `letters`, '.' or a group of those.
  PathEvents place(const std::string& letters, const std::string& what) {
    if (!take('[')) return letter_of(letters + ".", what + ", '.' or a group of those");
    return group(what + " or ']'", [&](const std::string& expected) { return letter_of(letters, expected); });
  }

  /// After '<'. A kind alone, <D>, is of either type.
  PathEvents type_and_kind() {
    const bool kind_alone = std::string_view("DGS").find(next()) != std::string_view::npos && !at_end();
    const PathEvents type = kind_alone ? every_event : place("RTCLOB", "an event type (R T C L O B)");
    if (take('>')) return type;
    const PathEvents kind = place("DGS", "a scattering kind (D G S)");
    if (!take('>')) fail("'>'");
    return type & kind;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string place_of_light_paths(const std::string& text) {
  constexpr std::size_t most_shown = 200;
  return fmt::format("light paths '{}{}'", text.substr(0, most_shown), text.size() > most_shown ? "…" : "");
}

PathExpression parse_light_paths(const std::string& text) { return {text, Parser(text).parse()}; }

}  // namespace gibench
