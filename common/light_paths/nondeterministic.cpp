#include "common/light_paths/nondeterministic.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/core/error.h"

namespace gibench {

namespace {

constexpr std::size_t most_states = 200000;
// Of an expression: some tenths of a second each. An expression of 65 535 states whose sets are small takes a fifteenth.
constexpr std::size_t most_parts = 2'000'000, most_steps = 30'000'000;

}  // namespace

NondeterministicPaths::NondeterministicPaths(const PathExpression& expression) : text_(expression.text) {
  states_.push_back({});  // the end
  start_ = compile(expression.root, end_);
  seen_.assign(states_.size(), 0);
}

void NondeterministicPaths::refuse_counts() const {
  throw InputError(place_of_light_paths(text_), fmt::format("its counts stand for more than {} events", most_states),
                   "lower them, or write * for no bound");
}

std::uint32_t NondeterministicPaths::add(State state) {
  if (states_.size() >= most_states) refuse_counts();
  states_.push_back(std::move(state));
  return static_cast<std::uint32_t>(states_.size() - 1);
}

/// The state from which the node is read and then what `then` reads.
std::uint32_t NondeterministicPaths::compile(const PathNode& node, std::uint32_t then) {
  if (++parts_ > most_parts) refuse_counts();
  switch (node.kind) {
    case PathNode::Kind::event: return add({true, node.events, {then}});
    case PathNode::Kind::sequence:
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) then = compile(*child, then);
      return then;
    case PathNode::Kind::choice: {
      std::vector<std::uint32_t> ways;
      for (const PathNode& child : node.children) ways.push_back(compile(child, then));
      return add({false, {}, std::move(ways)});
    }
    case PathNode::Kind::repeat: break;
  }
  return compile_repeat(node, then);
}

/// A{m,n} is A … A (A (A …)?)?: every copy that may be missing leads straight to what follows, so that no state sees
/// more than one copy ahead.
std::uint32_t NondeterministicPaths::compile_repeat(const PathNode& node, std::uint32_t then) {
  const PathNode& child = node.children.front();
  std::uint32_t entry = then;
  if (!node.most) {
    entry = add({});
    const std::uint32_t once = compile(child, entry);
    states_[entry].next = {once, then};
  }
  for (int i = node.least; node.most && i < *node.most; ++i) {
    const std::uint32_t once = compile(child, entry);
    entry = add({false, {}, {once, then}});
  }
  for (int i = 0; i < node.least; ++i) entry = compile(child, entry);
  return entry;
}

NondeterministicPaths::Set NondeterministicPaths::closure(Set states) {
  const std::size_t mark = ++closures_;
  const auto is_new = [&](std::uint32_t state) { return std::exchange(seen_[state], mark) != mark; };
  std::erase_if(states, [&](std::uint32_t state) { return !is_new(state); });
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State& state = states_[states[i]];
    if (state.takes_event) continue;
    for (const std::uint32_t next : state.next)
      if (is_new(next)) states.push_back(next);
  }
  std::sort(states.begin(), states.end());
  return states;
}

NondeterministicPaths::Set NondeterministicPaths::step(const Set& from, PathEvent event) {
  Set reached;
  for (const std::uint32_t state : from)
    if (states_[state].events.contains(event)) reached.push_back(states_[state].next.front());
  reached = closure(std::move(reached));
  steps_ += from.size() + reached.size();
  if (steps_ > most_steps)
    throw InputError(place_of_light_paths(text_), "its counts inside counts can be taken in too many ways",
                     "lower them, or write * for no bound");
  return reached;
}

}  // namespace gibench
