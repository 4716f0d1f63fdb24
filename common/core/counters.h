/// Counts of a run's work: rays, basis functions, iterations, … Counters belong to a run, never to the process.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace gibench {

/// Named counts. Not thread-safe: a parallel loop sums its own and adds the sum once.
class Counters {
 public:
  void add(std::string_view name, std::uint64_t amount) {
    const auto found = values_.find(name);
    if (found == values_.end()) values_.emplace(name, amount);
    else found->second += amount;
  }
  /// 0 for a name that was never counted.
  std::uint64_t operator[](std::string_view name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? 0 : found->second;
  }
  const std::map<std::string, std::uint64_t, std::less<>>& values() const { return values_; }

  /// What was counted since `before`, which must be an earlier state of these counters.
  Counters since(const Counters& before) const {
    Counters difference;
    for (const auto& [name, value] : values_)
      if (const std::uint64_t change = value - before[name]; change != 0) difference.add(name, change);
    return difference;
  }

 private:
  std::map<std::string, std::uint64_t, std::less<>> values_;
};

}  // namespace gibench
