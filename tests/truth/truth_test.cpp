// Every method against the cases whose answers are known, and the table of what each is asked.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <tuple>

#include "bounds.h"
#include "clearance.h"
#include "method_rules.h"
#include "pinned_runs.h"
#include "standard_errors.h"
#include "tolerances.h"

namespace gibench::truth {
namespace {

int number_of(const std::vector<std::vector<Question>>& groups) {
  int number = 0;
  for (const auto& group : groups) number += static_cast<int>(group.size());
  return number;
}

/// A method that the table has no column for: one that was added to the tree and is asked whatever it does not refuse.
bool is_pinned(const MethodRule& rule) { return pinned_runs().contains(rule.name()); }

using RuleAndCase = std::tuple<MethodRule, std::string>;

std::vector<RuleAndCase> all_runs() {
  std::vector<RuleAndCase> runs;
  for (const MethodRule& rule : all_rules())
    for (const std::string& id : case_ids())
      if (!is_pinned(rule) || pinned_runs().at(rule.name()).at(id).value_or(0) > 0) runs.emplace_back(rule, id);
  return runs;
}

class Truth : public testing::TestWithParam<RuleAndCase> {};

TEST_P(Truth, Holds) {
  const auto& [rule, id] = GetParam();
  const TruthCase truth = load_case(id);
  const auto groups = asked_of(rule, find_method(rule.method), truth);
  if (is_pinned(rule)) {
    ASSERT_EQ(number_of(groups), pinned_runs().at(rule.name()).at(id));
  } else if (groups.empty()) {
    GTEST_SKIP() << "nothing that " << rule.method << " is asked here";
  }
  if (rule.knows_its_errors) hold_to_standard_errors(rule, truth, groups);
  else hold_to_bounds(rule, truth, groups);
}

INSTANTIATE_TEST_SUITE_P(All, Truth, testing::ValuesIn(all_runs()),
                         [](const auto& one) { return std::get<0>(one.param).name() + "_" + std::get<1>(one.param); });

/// A method that begins to refuse a case, or to answer one, is a change that the table has to say.
TEST(TruthTable, SaysWhatEveryRuleAnswers) {
  std::set<std::string> columns, methods;
  for (const auto& [rule, cases] : pinned_runs()) columns.insert(rule);
  for (const MethodRule& rule : all_rules())
    if (columns.erase(rule.name()) > 0) methods.insert(rule.method);
  EXPECT_TRUE(columns.empty()) << "the table has a column for " << *columns.begin() << ", which is no rule";
  for (const MethodRule& rule : all_rules())
    EXPECT_EQ(is_pinned(rule), methods.contains(rule.method)) << "the table has no column for " << rule.name();
  for (const std::string& id : case_ids()) {
    const TruthCase truth = load_case(id);
    for (const MethodRule& rule : all_rules()) {
      if (!is_pinned(rule)) continue;
      const auto& cases = pinned_runs().at(rule.name());
      ASSERT_TRUE(cases.contains(id)) << id;
      if (const auto pinned = cases.at(id)) {
        EXPECT_EQ(number_of(asked_of(rule, find_method(rule.method), truth)), *pinned) << rule.name() << ' ' << id;
      }
    }
  }
}

/// No bound for a question or a case that is not asked, none that the tolerance makes needless, none above the ceiling.
TEST(TruthTable, EveryBoundIsOfSomethingAsked) {
  std::map<std::string, TruthCase> truths;
  for (const std::string& id : case_ids()) truths.emplace(id, load_case(id));
  for (const MethodRule& rule : all_rules()) {
    const Bounds bounds = bounds_of(rule.name());
    auto questions = bounds.questions, near_edges = bounds.near_edges;
    if (questions.empty() && near_edges.empty()) continue;
    for (const auto& [id, cell] : pinned_runs().at(rule.name())) {
      if (cell.value_or(0) == 0) continue;
      for (const auto& group : asked_of(rule, find_method(rule.method), truths.at(id)))
        for (const Question& question : group) {
          questions.erase(question.id);
          if (is_near_edge(truths.at(id), question)) near_edges.erase(near_key(id, question));
        }
    }
    for (const auto& [id, bound] : questions) ADD_FAILURE() << rule.name() << ": " << id << " is not asked";
    for (const auto& [id, bound] : near_edges) ADD_FAILURE() << rule.name() << ": nothing near an edge is asked of " << id;
    for (const auto& [id, bound] : bounds.questions) EXPECT_GT(bound.bound, bounds.tolerance) << rule.name() << ' ' << id;
    for (const auto& [id, bound] : bounds.near_edges) {
      EXPECT_GT(bound.bound, bounds.tolerance) << rule.name() << ' ' << id;
      EXPECT_LE(bound.bound, bounds.near_ceiling) << rule.name() << ' ' << id;
    }
  }
}

}  // namespace
}  // namespace gibench::truth
