#include "bench/measure/run_method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/core/error.h"

namespace gibench {
namespace {

using testing::HasSubstr;

/// A method for which new lights cost as much as a new scene; it is never asked for light.
class Unrelighting : public TransportMethod {
 public:
  Capabilities capabilities() const noexcept override { return {}; }
  void prepare(const World&, const EffectPlan&, Task&, StageReport&) override {}
  void light(const PlannedLights&, Task&, StageReport&) override {}
  void shade(const ShadeRequest&, const ShadeAnswer&, Task&, StageReport&) const override {}
};

TEST(Relighting, IsRefusedForAMethodThatDoesNotClaimIt) {
  const MethodEntry entry{
      "baked", "a double",
      "none",  "C.*[LOB]",
      {},      [](const Parameters&) -> std::unique_ptr<TransportMethod> {
                            return std::make_unique<Unrelighting>(); },
      {}};
  try {
    require_relighting({&entry, Parameters(entry.schema, {})});
    FAIL() << "it was taken";
  } catch (const InputError& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("--method"));
    EXPECT_THAT(refused.what(), HasSubstr("baked does not relight"));
    EXPECT_THAT(refused.what(), HasSubstr("spectral")) << "those that do are named";
  }
}

TEST(Relighting, IsOpenToAMethodThatClaimsIt) { EXPECT_NO_THROW(require_relighting(choose_method("spectral", {}))); }

}  // namespace
}  // namespace gibench
