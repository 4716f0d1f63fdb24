/// Functions as one visitor of a variant: an alternative that none of them takes does not compile.
#pragma once

namespace gibench {

/// For std::visit; no function of it is generic, so that a new alternative is not taken by accident.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace gibench
