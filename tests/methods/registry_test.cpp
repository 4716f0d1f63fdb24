#include "methods/registry.h"

#include <gtest/gtest.h>

#include "common/core/error.h"

namespace gibench {
namespace {

TEST(Registry, ListsAnAddedMethodAfterTheOthers) {
  const std::size_t before = all_methods().size();
  MethodEntry entry = find_method("pathtracer");
  entry.name = "added";
  add_method(entry);
  ASSERT_EQ(all_methods().size(), before + 1);
  EXPECT_EQ(all_methods().front().name, "pathtracer");
  EXPECT_EQ(all_methods().back().name, "added");
  EXPECT_EQ(find_method("added").summary, entry.summary);
}

TEST(Registry, TakesNoNameTwice) {
  const std::size_t before = all_methods().size();
  EXPECT_THROW(add_method(find_method("meshless")), InputError);
  EXPECT_EQ(all_methods().size(), before);
}

}  // namespace
}  // namespace gibench
