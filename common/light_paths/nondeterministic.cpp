#include "common/light_paths/nondeterministic.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/error.h"

namespace gibench {

namespace {

constexpr std::size_t most_states = 200000;

}  // namespace

NondeterministicPaths::NondeterministicPaths(const PathExpression& expression) : text_(expression.text) {
  states_.push_back({});  // the end
  start_ = compile(expression.root, end_);
}

std::uint32_t NondeterministicPaths::add(State state) {
  if (states_.size() >= most_states)
    throw InputError(fmt::format("light paths '{}'", text_), fmt::format("its counts stand for more than {} events", most_states),
                     "lower them, or write * for no bound");
  states_.push_back(std::move(state));
  return static_cast<std::uint32_t>(states_.size() - 1);
}

/// The state from which the node is read and then what `then` reads.
std::uint32_t NondeterministicPaths::compile(const PathNode& node, std::uint32_t then) {
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

NondeterministicPaths::Set NondeterministicPaths::closure(Set states) const {
  std::vector<std::uint32_t> open = states;
  std::sort(states.begin(), states.end());
  states.erase(std::unique(states.begin(), states.end()), states.end());
  while (!open.empty()) {
    const State& state = states_[open.back()];
    open.pop_back();
    if (state.takes_event) continue;
    for (const std::uint32_t next : state.next) {
      const auto place = std::lower_bound(states.begin(), states.end(), next);
      if (place != states.end() && *place == next) continue;
      states.insert(place, next);
      open.push_back(next);
    }
  }
  return states;
}

NondeterministicPaths::Set NondeterministicPaths::step(const Set& from, PathEvent event) const {
  Set reached;
  for (const std::uint32_t state : from)
    if (states_[state].events.contains(event)) reached.push_back(states_[state].next.front());
  return closure(std::move(reached));
}

}  // namespace gibench
