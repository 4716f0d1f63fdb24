/// Transport by direction: what bent nodes pass down, and what 16 bits round.
#include "methods/antiradiance/bin_transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/antiradiance/discretisation.h"

namespace gibench::antiradiance {
namespace {

Settings plain_settings() {
  return settings_from(
      Parameters(settings_schema(), {{"elements", "1"}, {"closure_rays", "0"}, {"backface_rays", "0"}, {"merge", "false"}}));
}

/// A roof of two faces, 45 degrees steep, and a square far above it that faces down.
Scene roof_below_a_square() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const float h = 1.0F;
  builder.object(
      "roof", white,
      {{-1.0F, 0.0F, 1.0F}, {0.0F, h, 1.0F}, {0.0F, h, -1.0F}, {-1.0F, 0.0F, -1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, -1.0F}},
      {{0, 1, 2, 3}, {4, 5, 2, 1}});
  builder.quad("square", white, {{{-1.0F, 9.0F, -1.0F}, {1.0F, 9.0F, -1.0F}, {1.0F, 9.0F, 1.0F}, {-1.0F, 9.0F, 1.0F}}});
  return builder.build("roof");
}

/// Of one radiance in every bin, whatever the slope: of what a surface shows little to, little arrives.
TEST(BinTransport, BentNodesPassRadianceDown) {
  const World world(roof_below_a_square());
  Task task;
  const Discretisation parts(world, plain_settings(), task);
  const auto nodes = parts.hierarchy.nodes();
  const auto node_of = [&](std::uint32_t sheet) {
    return static_cast<std::uint32_t>(
        std::find_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.sheet == sheet; }) - nodes.begin());
  };
  const std::uint32_t roof = node_of(0), square = node_of(2);
  ASSERT_LT(nodes[roof].cone_sine, 1.0F);
  ASSERT_GT(nodes[roof].cone_sine, 0.6F);
  LinkTable links;
  for (std::uint32_t i = 0; i <= parts.hierarchy.size(); ++i) links.row_begin.push_back(i <= roof ? 0 : 1);
  links.senders.push_back({square});
  links.factors.push_back(0.01F);
  const DirectionBins bins(12);
  const Vec3 down = glm::normalize(Vec3(0.3F, -1.0F, 0.1F));
  make_masks(parts.hierarchy, bins, std::vector<Vec3>{down}, links, task);
  BinTransport transport(parts.hierarchy, links, bins);
  Vector incident;
  transport.transport_sources(std::vector<Rgb>(parts.hierarchy.leaf_count(), Rgb(1.0F)), {}, incident, task);

  std::vector<float> projected(bins.count()), at_node(bins.count());
  projected_bins(bins, nodes[roof].normal, at_node);
  const auto& quad = bins.bins_of(links.masks[0].quad);
  for (std::uint32_t leaf = nodes[roof].begin; leaf < nodes[roof].end; ++leaf) {
    projected_bins(bins, nodes[parts.hierarchy.leaf_node(leaf)].normal, projected);
    for (std::size_t k = 0; k < 4; ++k) {
      const float sent = 0.01F * static_cast<float>(links.masks[0].receive.weights[k]) / 255.0F;
      const float expected = sent * std::fabs(projected[quad[k]] / at_node[quad[k]]);
      const float arrived = incident[static_cast<Eigen::Index>((leaf * bins.count() + quad[k]) * channels)];
      // Both are held to sums of π, by a few percent with so many bins.
      EXPECT_NEAR(arrived, expected, 0.05F * expected + 1e-6F) << leaf << ' ' << k;
    }
  }
}

/// A radiosity that is the same everywhere is whole units: nothing is rounded on the way.
TEST(BinTransport, RoundsNoUniformLight) {
  const World world(roof_below_a_square());
  Task task;
  const Discretisation parts(world, plain_settings(), task);
  LinkTable links;
  const auto count = static_cast<std::uint32_t>(parts.hierarchy.size());
  for (std::uint32_t i = 0; i <= count; ++i) links.row_begin.push_back(i == count ? 1 : 0);
  const std::uint32_t sender = parts.hierarchy.leaf_node(0);
  links.senders.push_back({sender});
  links.factors.push_back(0.25F);
  const DirectionBins bins(8);
  make_masks(parts.hierarchy, bins, std::vector<Vec3>{parts.hierarchy.nodes()[sender].normal}, links, task);
  BinTransport transport(parts.hierarchy, links, bins);
  Vector incident;
  const float radiosity = 0.7F;
  transport.transport_sources(std::vector<Rgb>(parts.hierarchy.leaf_count(), Rgb(radiosity)), {}, incident, task);
  EXPECT_NEAR(incident.sum() / 3.0F, 0.25F * radiosity, 1e-6F);
}

}  // namespace
}  // namespace gibench::antiradiance
