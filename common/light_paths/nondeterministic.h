/// Thompson's automaton of a light-path expression: what the deterministic one is made from.
#pragma once

#include <cstdint>
#include <vector>

#include "common/light_paths/expression.h"

namespace gibench {

/// States and edges; a path is read by following all edges that fit.
class NondeterministicPaths {
 public:
  using Set = std::vector<std::uint32_t>;  ///< sorted states, closed under the edges that take no event

  explicit NondeterministicPaths(const PathExpression& expression);

  Set start() { return closure({start_}); }
  /// Throws InputError where this and all steps before came upon too many states: counts inside counts make sets of thousands.
  Set step(const Set& from, PathEvent event);
  bool accepts(const Set& set) const { return !set.empty() && set.front() == end_; }

 private:
  /// An edge that takes one of `events`, or edges that take none.
  struct State {
    bool takes_event = false;
    PathEvents events;
    std::vector<std::uint32_t> next;
  };
  [[noreturn]] void refuse_counts() const;
  std::uint32_t add(State state);
  std::uint32_t compile(const PathNode& node, std::uint32_t then);
  std::uint32_t compile_repeat(const PathNode& node, std::uint32_t then);
  Set closure(Set states);

  static constexpr std::uint32_t end_ = 0;
  const std::string& text_;
  std::vector<State> states_;
  std::uint32_t start_ = 0;
  std::size_t parts_ = 0, steps_ = 0;  ///< compiled, followed: what the work is bounded by
  std::vector<std::size_t> seen_;      ///< by state: the last closure that has it
  std::size_t closures_ = 0;
};

}  // namespace gibench
