/// The direct transport operator: equal to the dense one at full depth, reciprocal, bounded by the light that there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/core/random.h"
#include "methods/wavelet/blocks.h"
#include "methods/wavelet/bounces.h"
#include "methods/wavelet/closure.h"
#include "methods/wavelet/operator_making.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace wavelet;

struct Made {
  World world;
  Task task;
  Elements elements;
  Kernel kernel;
  Blocks blocks;
  OperatorMaking made;

  Made(Scene scene, double leaf_area, double receiver, double sender, double compression = 0.0,
       KernelForm form = KernelForm::polygons)
      : world(std::move(scene), 1),
        elements(world, {leaf_area, true, 4}, task),
        kernel(world, elements, {form, true, 16, 1}),
        blocks(world, elements, kernel, {receiver, sender, 1U << 24U}, task),
        made(make_operator(elements, blocks, compression, Precision::bits32, task)) {}

  std::vector<Rgb> transported(const std::vector<Rgb>& leaf_means) {
    const Coefficients<Rgb> in = coefficients_of<Rgb>(elements, leaf_means);
    Coefficients<Rgb> out(in.size());
    made.transport.apply(elements, in, out, task);
    return leaf_means_of<Rgb>(elements, out);
  }
};

TEST(WaveletOperator, AtFullDepthEqualsTheDenseOne) {
  Made made(open_corner(), 0.02, 0.0, 0.0);
  const std::span leaves = made.elements.leaves();
  RandomStream random(3, 1, 4);
  std::vector<Rgb> radiosity(leaves.size());
  for (Rgb& value : radiosity) value = Rgb(random.next_float());
  RayStream rays = made.task.rays(made.world);
  std::vector<double> dense(leaves.size(), 0.0);
  double mean = 0.0;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    for (std::size_t j = i + 1; j < leaves.size(); ++j) {
      if (made.elements.nodes()[leaves[i]].element == made.elements.nodes()[leaves[j]].element) continue;
      const double exchange = static_cast<double>(made.kernel.between(leaves[i], leaves[j], rays).total);
      dense[i] += exchange * static_cast<double>(radiosity[j].r) / static_cast<double>(made.elements.nodes()[leaves[i]].area);
      dense[j] += exchange * static_cast<double>(radiosity[i].r) / static_cast<double>(made.elements.nodes()[leaves[j]].area);
    }
  for (const double value : dense) mean += value / static_cast<double>(dense.size());
  const std::vector<Rgb> sparse = made.transported(radiosity);
  for (std::size_t i = 0; i < leaves.size(); ++i) EXPECT_NEAR(static_cast<double>(sparse[i].r), dense[i], 1e-5 * mean);
}

TEST(WaveletOperator, IsReciprocalToTheLastBitButRounding) {
  Made made(open_corner(), 0.01, 0.003, 0.003);
  std::size_t links = 0;
  for (std::uint32_t receiver = 0; receiver < made.elements.groups().size(); ++receiver)
    made.made.transport.each_link(made.elements, receiver, [&](std::uint32_t sender, std::span<const float> there) {
      const std::size_t rows = made.elements.groups()[receiver].functions(), columns = made.elements.groups()[sender].functions();
      bool found = false;
      made.made.transport.each_link(made.elements, sender, [&](std::uint32_t back, std::span<const float> here) {
        if (back != receiver) return;
        found = true;
        for (std::size_t k = 0; k < rows; ++k)
          for (std::size_t j = 0; j < columns; ++j) EXPECT_NEAR(there[k * columns + j], here[j * rows + k], 2e-7F);
      });
      EXPECT_TRUE(found);
      ++links;
    });
  EXPECT_GT(links, 100U);
}

TEST(WaveletOperator, CompressionLeavesOutWhatItCounts) {
  Made whole(open_corner(), 0.01, 0.003, 0.003), part(open_corner(), 0.01, 0.003, 0.003, 1e-3);
  EXPECT_EQ(whole.made.dropped_links, 0U);
  EXPECT_EQ(part.made.dropped_links + part.made.transport.links(), whole.made.transport.links());
  EXPECT_GT(part.made.dropped_links, 100U);
  EXPECT_LT(part.made.dropped_share, 0.05);
}

TEST(WaveletOperator, SixteenBitsChangeLittleAndTakeHalfTheMemory) {
  Made made(open_corner(), 0.01, 0.003, 0.003);
  const std::vector<Rgb> ones(made.elements.leaves().size(), Rgb(1.0F));
  const std::vector<Rgb> whole = made.transported(ones);
  const std::size_t bytes = made.made.transport.bytes();
  made.made = make_operator(made.elements, made.blocks, 0.0, Precision::bits16, made.task);
  const std::vector<Rgb> packed = made.transported(ones);
  for (std::size_t i = 0; i < ones.size(); ++i) EXPECT_NEAR(packed[i].r, whole[i].r, 1e-3F);
  EXPECT_LT(made.made.transport.bytes(), bytes * 2 / 3);
}

TEST(WaveletOperator, ClosedRoomsAreHeldToTheirSums) {
  Made made(furnace(0.5F), 0.05, 0.003, 0.003);
  const std::vector<float> ones(made.elements.nodes().size(), 1.0F);
  const auto worst = [&] {
    float largest = 0.0F;
    for (const float sum : uniform_response(made.elements, made.blocks, ones, made.task))
      largest = std::max(largest, std::fabs(sum - 1.0F));
    return largest;
  };
  EXPECT_LT(worst(), 0.1F);
  const float off = hold_to_sums(made.world, made.elements, 64, made.blocks, made.task);
  EXPECT_NEAR(worst(), off, 1e-5F);
  EXPECT_LT(off, 2e-3F);
  made.made = make_operator(made.elements, made.blocks, 0.0, Precision::bits32, made.task);
  for (const Rgb& value : made.transported(std::vector<Rgb>(made.elements.leaves().size(), Rgb(1.0F))))
    EXPECT_NEAR(value.g, 1.0F, off + 1e-5F);
}

/// Quads on top of each other, through each other, and edge to edge.
TEST(WaveletOperator, TouchingAndCrossingSurfacesGiveFiniteBoundedLinks) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  const std::array<Vec3, 4> floor{{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}};
  builder.quad("floor", white, floor, true).quad("twin", white, floor, true);
  builder.quad("crossing", white, {{{0.5F, -0.5F, 0}, {0.5F, -0.5F, 1}, {0.5F, 0.5F, 1}, {0.5F, 0.5F, 0}}}, true);
  builder.quad("touching", white, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, true);
  builder.quad("close", white, {{{0, 1e-3F, 0}, {0, 1e-3F, 0.3F}, {0.3F, 1e-3F, 0.3F}, {0.3F, 1e-3F, 0}}}, true);
  for (const KernelForm form : {KernelForm::polygons, KernelForm::samples}) {
    Made made(builder.build("touching"), 0.02, 0.003, 0.003, 0.0, form);
    hold_to_sums(made.world, made.elements, 0, made.blocks, made.task);
    made.made = make_operator(made.elements, made.blocks, 0.0, Precision::bits32, made.task);
    for (const Rgb& value : made.transported(std::vector<Rgb>(made.elements.leaves().size(), Rgb(1.0F)))) {
      EXPECT_TRUE(std::isfinite(value.g));
      if (form == KernelForm::samples) continue;  // which spikes where surfaces touch
      EXPECT_GE(value.g, -1e-4F);
      EXPECT_LE(value.g, 1.02F);
    }
  }
}

/// Both lie in one plane, in which rounding alone tells front from back.
TEST(WaveletOperator, BothSidesOfATiltedSheetGiveEachOtherNothing) {
  for (const float tilt : {0.1F, 0.37F, 0.9F, 1.3F})
    for (const Vec3& at : {Vec3(0.0F), Vec3(7.3F, -2.1F, 5.7F)}) {
      made::SceneBuilder builder;
      const Vec3 u(std::cos(tilt), std::sin(tilt), 0.31F), v(-0.2F * std::sin(tilt), 0.2F * std::cos(tilt), 0.7F);
      builder.quad("sheet", builder.diffuse("white", Rgb(0.8F)), {{at, at + u, at + u + v, at + v}}, true);
      Made made(builder.build("sheet"), 0.01, 0.0, 0.0);
      EXPECT_EQ(made.blocks.size(), 0U);
      for (const Rgb& value : made.transported(std::vector<Rgb>(made.elements.leaves().size(), Rgb(1.0F))))
        EXPECT_EQ(value.g, 0.0F);
    }
}

/// A unit cube with a square in its ceiling, which is black or missing: light finds no difference.
Scene room_with_window(bool is_open, float side, float albedo) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(albedo)), black = builder.diffuse("black", Rgb(0.0F));
  const float low = 0.5F - 0.5F * side, high = 0.5F + 0.5F * side;
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 0, 1},     {0, 0, 1},      {0, 1, 0},       {1, 1, 0},
                                  {1, 1, 1}, {0, 1, 1}, {low, 1, low}, {high, 1, low}, {high, 1, high}, {low, 1, high}};
  builder.object("room", white, corners,
                 {{0, 3, 2, 1},
                  {0, 1, 5, 4},
                  {1, 2, 6, 5},
                  {2, 3, 7, 6},
                  {3, 0, 4, 7},
                  {4, 5, 9, 8},
                  {5, 6, 10, 9},
                  {6, 7, 11, 10},
                  {7, 4, 8, 11}});
  if (!is_open) builder.object("window", black, corners, {{8, 9, 10, 11}});
  return builder.build("window");
}

/// All indirect light, W, of even direct light on what is white.
double indirect_of(Scene scene, float albedo) {
  Made made(std::move(scene), 0.01, 0.002, 0.002);
  hold_to_sums(made.world, made.elements, 64, made.blocks, made.task);
  made.made = make_operator(made.elements, made.blocks, 0.0, Precision::bits32, made.task);
  std::vector<Rgb> reflectance;
  for (const Element& element : made.elements.elements())
    reflectance.push_back(made.world.scene().material_of_object(element.object).diffuse);
  std::vector<Rgb> direct;
  double found = 0.0;
  for (const std::uint32_t leaf : made.elements.leaves())
    direct.push_back(reflectance[made.elements.nodes()[leaf].element].r > 0.0F ? Rgb(1.0F) : Rgb(0.0F));
  const IndirectLight light = bounce(made.elements, made.made.transport, coefficients_of<Rgb>(made.elements, direct), reflectance,
                                     {{}, 10000, 1e-5}, made.task);
  const std::vector<Rgb> means = leaf_means_of<Rgb>(made.elements, light.irradiance);
  for (std::size_t i = 0; i < means.size(); ++i)
    found += static_cast<double>(direct[i].r * means[i].g * made.elements.nodes()[made.elements.leaves()[i]].area);
  EXPECT_GT(found, static_cast<double>(albedo));
  return found;
}

TEST(WaveletOperator, ASmallWindowLetsLightOut) {
  constexpr float albedo = 0.9F;
  const double closed = indirect_of(room_with_window(false, 0.25F, albedo), albedo),
               open = indirect_of(room_with_window(true, 0.25F, albedo), albedo);
  EXPECT_NEAR(open / closed, 1.0, 0.01);
}

TEST(WaveletOperator, ClosedRoomsKeepTheirEnergy) {
  constexpr float albedo = 0.8F;
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(albedo));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.block("block", white, {0.3F, 0.2F, 0.4F}, {0.6F, 0.5F, 0.8F}, 20.0F);
  Made made(builder.build("room with a block in the air"), 0.01, 0.002, 0.002);
  hold_to_sums(made.world, made.elements, 256, made.blocks, made.task);
  made.made = make_operator(made.elements, made.blocks, 0.0, Precision::bits32, made.task);
  const std::span leaves = made.elements.leaves();
  std::vector<Rgb> direct(leaves.size());
  double given = 0.0, found = 0.0;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const bool lit = made.elements.nodes()[leaves[i]].patch.middle().x < 0.2F;
    direct[i] = Rgb(lit ? 1.0F : 0.0F);
    given += lit ? static_cast<double>(made.elements.nodes()[leaves[i]].area) : 0.0;
  }
  const std::vector<Rgb> reflectance(made.elements.elements().size(), Rgb(albedo));
  const IndirectLight light = bounce(made.elements, made.made.transport, coefficients_of<Rgb>(made.elements, direct), reflectance,
                                     {{}, 10000, 1e-5}, made.task);
  const std::vector<Rgb> means = leaf_means_of<Rgb>(made.elements, light.irradiance);
  for (std::size_t i = 0; i < leaves.size(); ++i)
    found += static_cast<double>(means[i].g * made.elements.nodes()[leaves[i]].area);
  EXPECT_NEAR(found / (given * 0.8 / 0.2), 1.0, 0.005);
}

}  // namespace
}  // namespace gibench::test
