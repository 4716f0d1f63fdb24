#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/core/error.h"
#include "common/reference/merge.h"
#include "tests/common/reference/references.h"

namespace gibench {
namespace {

/// The mean of samples [first, last) of each replicate: what a path tracer with that many samples would give.
Reference sampled(std::uint64_t first, std::uint64_t last) {
  Reference reference = test::random_reference(test::image_question(), 1);
  reference.samples_per_replica = reference.image_samples_per_replica = last - first;
  reference.seconds = 0.5 * static_cast<double>(last - first);
  std::uint64_t stage = 0;
  for (Replicas* set :
       {&reference.surface.direct, &reference.surface.indirect, &reference.image.direct, &reference.image.indirect}) {
    ++stage;
    for (std::size_t r = 0; r < set->count(); ++r)
      for (std::size_t i = 0; i < set->size(); ++i) {
        RgbDouble sum;
        for (std::uint64_t sample = first; sample < last; ++sample) {
          RandomStream random(1000 * stage + r, i, sample);
          sum += RgbDouble(random.next_double(), random.next_double(), random.next_double());
        }
        set->replicas[r][i] = Rgb(sum / static_cast<double>(last - first));
      }
  }
  return reference;
}

void expect_near(const Replicas& a, const Replicas& b) {
  ASSERT_EQ(a.count(), b.count());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t r = 0; r < a.count(); ++r)
    for (std::size_t i = 0; i < a.size(); ++i)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(a.replicas[r][i][c], b.replicas[r][i][c], 3e-7F);
}

TEST(ReferenceMerge, ExtendedEqualsOneShot) {
  Reference extended = sampled(0, 16);
  merge(extended, sampled(16, 24));
  merge(extended, sampled(24, 100));
  const Reference at_once = sampled(0, 100);
  EXPECT_EQ(extended.samples_per_replica, 100U);
  EXPECT_DOUBLE_EQ(extended.seconds, 50.0);
  expect_near(extended.surface.direct, at_once.surface.direct);
  expect_near(extended.surface.indirect, at_once.surface.indirect);
  expect_near(extended.image.direct, at_once.image.direct);
  expect_near(extended.image.indirect, at_once.image.indirect);
}

TEST(ReferenceMerge, PicturesCountTheirOwnSamples) {
  Reference extended = sampled(0, 16);
  Reference more = sampled(16, 24);
  more.image_samples_per_replica = 0;
  merge(extended, more);
  EXPECT_EQ(extended.samples_per_replica, 24U);
  EXPECT_EQ(extended.image_samples_per_replica, 16U);
  expect_near(extended.surface.indirect, sampled(0, 24).surface.indirect);
  expect_near(extended.image.indirect, sampled(0, 16).image.indirect);
}

TEST(ReferenceMerge, NothingMoreChangesNothing) {
  Reference reference = sampled(0, 16);
  Reference nothing = reference;
  nothing.samples_per_replica = nothing.image_samples_per_replica = 0;
  nothing.seconds = 0.0;
  merge(reference, nothing);
  EXPECT_EQ(reference.image.direct.replicas, sampled(0, 16).image.direct.replicas);
  EXPECT_EQ(reference.samples_per_replica, 16U);
}

TEST(ReferenceMerge, WhatDoesNotBelongTogetherIsRefused) {
  const Reference reference = sampled(0, 2);
  const auto refused = [&](const std::function<void(Reference&)>& change) {
    Reference other = sampled(2, 4), into = reference;
    change(other);
    EXPECT_THROW(merge(into, other), InputError);
    EXPECT_EQ(into.image.direct.replicas, reference.image.direct.replicas) << "a refused merge changes nothing";
  };
  refused([](Reference& r) { r.question.path_class = "C[LOB]"; });
  refused([](Reference& r) { r.question.seed = 9; });
  refused([](Reference& r) { r.question.camera.reset(); });
  refused([](Reference& r) { r.question.camera->position.x += 1.0F; });
  refused([](Reference& r) { r.surface.direct.replicas.pop_back(); });
  refused([](Reference& r) {
    for (auto& replica : r.image.indirect.replicas) replica.pop_back();
  });
}

TEST(RelativeStandardError, IsThatOfTheMean) {
  // Two values, two replicates: means 2 and 4, standard errors of the mean 1 and 0.
  Replicas set;
  set.replicas = {{Rgb(1.0F), Rgb(4.0F)}, {Rgb(3.0F), Rgb(4.0F)}};
  EXPECT_NEAR(relative_standard_error(set).value(), std::sqrt((1.0 + 0.0) / (4.0 + 16.0)), 1e-7);
  EXPECT_FALSE(relative_standard_error({}));
  set.replicas.pop_back();
  EXPECT_FALSE(relative_standard_error(set));
  set.replicas = {{Rgb(0.0F)}, {Rgb(0.0F)}};
  EXPECT_FALSE(relative_standard_error(set));
}

}  // namespace
}  // namespace gibench
