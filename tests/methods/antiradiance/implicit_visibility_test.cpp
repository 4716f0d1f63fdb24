/// Implicit visibility: what a bin's nearest sender gets wrong, and that it vanishes as bins and elements get smaller.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/scene/made_scenes.h"
#include "solved_scene.h"

namespace gibench {
namespace {

/// A bright wall, a receiver before it, and between them a plate much smaller than a bin.
Scene small_blocker(float shift) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.8F)), black = builder.diffuse("black", Rgb(0.0F));
  builder.quad("receiver", white, {{{0.4F, 0.0F, 0.6F}, {0.6F, 0.0F, 0.6F}, {0.6F, 0.0F, 0.4F}, {0.4F, 0.0F, 0.4F}}});
  builder.quad("bright", white, {{{0.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 1.0F}, {0.0F, 1.0F, 1.0F}}});
  // Nine specks: a thousandth of the area that they hide.
  for (int i = 0; i < 9; ++i) {
    const float x = 0.38F + 0.12F * static_cast<float>(i % 3) + shift, z = 0.38F + 0.12F * static_cast<float>(i / 3), s = 0.002F;
    builder.quad("speck " + std::to_string(i), black, {{{x, 0.5F, z}, {x + s, 0.5F, z}, {x + s, 0.5F, z + s}, {x, 0.5F, z + s}}});
  }
  builder.light(PointLight{{0.5F, 0.45F, 0.9F}, Rgb(1.0F)});
  return builder.build("small blocker");
}

TEST(ImplicitVisibility, LetsASpeckHideAWall) {
  const Setting implicit{{"mode", "implicit"}, {"elements", "800"}, {"bins", "8"}, {"bin_winner", "links"}},
      radiosity{{"mode", "radiosity"}, {"elements", "800"}};
  const auto lost = [&](float shift) {
    Solved traced(small_blocker(shift), radiosity), nearest(small_blocker(shift), implicit);
    std::vector<SurfaceSample> samples;
    for (const SurfaceSample& sample : traced.samples(4000))
      if (sample.object == 0) samples.push_back(sample);
    return 1.0 - mean(nearest.irradiance(samples)) / mean(traced.irradiance(samples));
  };
  // The specks hide a thousandth; the bins that they are nearest in are lost as a whole.
  const double here = lost(0.0F);
  EXPECT_GT(here, 0.05);
  // And as they move by a twentieth, other bins are lost: what a moving blocker does flickers.
  EXPECT_GT(std::fabs(lost(0.05F) - here), 0.005);
}

/// How far implicit visibility is from traced visibility on as many elements in the room with blocks, for each number of bins.
std::vector<double> implicit_differences(const char* elements, const char* winner, const std::vector<std::string>& bins) {
  const Scene scene = made::box_scene();
  Solved traced(scene, {{"mode", "radiosity"}, {"elements", elements}, {"visibility_rays", "16"}});
  const auto samples = traced.samples();
  const auto expected = traced.irradiance(samples);
  std::vector<double> differences;
  for (const std::string& number : bins) {
    Solved nearest(scene, {{"mode", "implicit"}, {"elements", elements}, {"bins", number}, {"bin_winner", winner}});
    differences.push_back(difference(nearest.irradiance(samples), expected));
  }
  return differences;
}

TEST(ImplicitVisibility, ComesToTracedVisibilityAsBinsGrow) {
  // Wrong are the bins that the outline of a surface crosses: at most half as many, as a share, where bins are half as wide.
  const auto middle = implicit_differences("800", "middle", {"4", "8", "16"});
  EXPECT_LT(middle[1], 0.5 * middle[0]);
  EXPECT_LT(middle[2], 0.5 * middle[1]);
  const auto links = implicit_differences("800", "links", {"8", "16", "32"});
  EXPECT_LT(links[2], 0.5 * links[1]);
  // A sender of which only a corner lies in a bin takes all of it.
  EXPECT_GT(links[0], 2.0 * middle[1]);
  EXPECT_GT(links[1], 2.0 * middle[2]);
}

TEST(ImplicitVisibility, ComesToTracedVisibilityAsElementsGrow) {
  // With many bins what is left comes from taking elements for squares, first order in their edges; a tenth is for the bins.
  const double coarse = implicit_differences("400", "middle", {"32"}).front(),
               fine = implicit_differences("1600", "middle", {"32"}).front();
  EXPECT_LT(fine, 0.6 * coarse);
  EXPECT_LT(coarse, 0.05);
}

}  // namespace
}  // namespace gibench
