#include "tolerances.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>

#include "asking.h"
#include "bounds.h"
#include "clearance.h"

namespace gibench::truth {

namespace {

constexpr int mean_points = 16384;

/// What is asked in one quantity, component and bounce bound; form factors are apart, which are no light.
std::tuple<Quantity, Component, std::optional<int>, bool> group_of(const Question& question) {
  return {question.quantity, question.component, question.bounces, question.emitters.empty()};
}

/// The values that misses are shares of.
class Scales {
 public:
  explicit Scales(const std::vector<std::vector<Question>>& asked) {
    for (const auto& questions : asked)
      for (const Question& question : questions)
        largest_[group_of(question)] = std::max(largest_[group_of(question)], largest(question.value));
  }
  double of(const Question& question, int channel) const {
    return std::max(std::fabs(question.value[channel]), 0.1 * largest_.at(group_of(question)));
  }

 private:
  std::map<decltype(group_of(Question())), double> largest_;
};

/// The largest share over the channels by which the answer is further from the truth than the truth is uncertain.
double miss_of(const Answer& answer, const Question& question, const Scales& scales) {
  double worst = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double excess = std::fabs(answer.value[c] - question.value[c]) - question.uncertainty[c],
                 scale = scales.of(question, c);
    if (std::isnan(excess)) return std::numeric_limits<double>::infinity();
    if (excess > 0.0) worst = std::max(worst, excess / scale);
  }
  return worst;
}

const char* const wanted_seeds = std::getenv("GIBENCH_TRUTH_SEEDS");
bool tells_every_miss() { return wanted_seeds != nullptr; }
int seeds() { return tells_every_miss() ? std::max(1, std::atoi(wanted_seeds)) : 1; }

}  // namespace

void hold_to_bounds(const MethodRule& rule, const TruthCase& truth, const std::vector<std::vector<Question>>& groups) {
  const Bounds bounds = bounds_of(rule.name());
  const Scales scales(groups);
  double worst[2] = {0.0, 0.0};  // away from edges, near them
  for (int seed = 1; seed <= seeds(); ++seed)
    for (const auto& group : groups) {
      const auto answers =
          ask(find_method(rule.method), *truth.world, group, {rule.settings, static_cast<std::uint64_t>(seed), 1, mean_points});
      for (std::size_t i = 0; i < group.size(); ++i) {
        const bool near = is_near_edge(truth, group[i]);
        const double miss = miss_of(answers[i], group[i], scales);
        worst[near ? 1 : 0] = std::max(worst[near ? 1 : 0], miss);
        if (tells_every_miss())
          fmt::print("{} {} {} seed {}: {:.3f}%\n", rule.name(), group[i].id, near ? "near" : "clear", seed, 100.0 * miss);
        EXPECT_LE(miss, bounds.bound_of(truth.id, group[i], near)) << tell(answers[i], group[i]);
      }
    }
  fmt::print("{}: off by {:.2f}% at most, by {:.2f}% near edges\n", truth.id, 100.0 * worst[0], 100.0 * worst[1]);
}

}  // namespace gibench::truth
