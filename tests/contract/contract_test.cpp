/// Every promise, on every technique of every registered method.
#include "tests/contract/contract.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "methods/registry.h"

namespace gibench::contract {
namespace {

/// Of every registered method.
const std::vector<MethodEntry>& all_techniques() {
  static const std::vector<MethodEntry> all = [] {
    std::vector<MethodEntry> techniques;
    for (const MethodEntry& entry : all_methods())
      for (MethodEntry& technique : techniques_of(entry)) techniques.push_back(std::move(technique));
    return techniques;
  }();
  return all;
}

using MethodAndCheck = std::tuple<std::size_t, std::size_t>;

class Contract : public testing::TestWithParam<MethodAndCheck> {};

TEST_P(Contract, Holds) {
  const auto& [method, check] = GetParam();
  const std::string violation = violation_of(all_checks()[check], all_techniques()[method]);
  EXPECT_TRUE(violation.empty()) << violation;
}

std::string name_of(const testing::TestParamInfo<MethodAndCheck>& info) {
  return all_techniques()[std::get<0>(info.param)].name + "_" + all_checks()[std::get<1>(info.param)].name;
}

INSTANTIATE_TEST_SUITE_P(EveryTechnique, Contract,
                         testing::Combine(testing::Range<std::size_t>(0, all_techniques().size()),
                                          testing::Range<std::size_t>(0, all_checks().size())),
                         name_of);

}  // namespace
}  // namespace gibench::contract
