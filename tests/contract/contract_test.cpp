/// Every promise, on every technique of every registered method.
#include "tests/contract/contract.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace gibench::contract {
namespace {

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
