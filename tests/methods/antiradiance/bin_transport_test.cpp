/// Transport by direction: what bent nodes pass down, and what 16 bits round.
#include "methods/antiradiance/bin_transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
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

/// So many sheets in line above a lit square, as far apart as asked for.
Scene sheets_in_line(int count, float spacing) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  for (int i = 0; i < count; ++i) {
    const float y = 0.3F + spacing * static_cast<float>(i);
    builder.quad("sheet " + std::to_string(i), white, {{{0.0F, y, 0.0F}, {1.0F, y, 0.0F}, {1.0F, y, 1.0F}, {0.0F, y, 1.0F}}});
  }
  builder.quad("lit", white, {{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}}});
  return builder.build("sheets in line");
}

/// Terms of both series for light that the lit square sends, as norms.
struct TermsInLine {
  TermsInLine(int sheets, float spacing, int terms) {
    const World world(sheets_in_line(sheets, spacing));
    Task task;
    Settings settings = plain_settings();
    settings.elements = 300;
    const Discretisation parts(world, settings, task);
    const Linking linking = make_linking(world, parts, settings, Visibility::antiradiance, {}, task);
    BinTransport transport(parts.hierarchy, linking.links, *linking.bins);
    std::vector<Rgb> sent;
    for (const std::uint32_t element : parts.hierarchy.order())
      sent.push_back(parts.elements.sheet(element) / 2 == static_cast<std::uint32_t>(sheets) ? Rgb(1.0F) : Rgb());
    const std::vector<Rgb> albedo(sent.size(), Rgb(0.5F));
    const Reflection reflection{albedo, {}, nullptr};
    Vector first, next;
    transport.transport_sources(sent, {}, first, task);
    Vector taken = first, all = first;
    for (int k = 0; k < terms; ++k) {
      transport.transport_through(taken, next, task);
      taken.swap(next);
      taken_away.push_back(static_cast<double>(taken.norm() / first.norm()));
      transport.transport(all, reflection, next, task);
      all.swap(next);
      at_once.push_back(static_cast<double>(all.norm() / first.norm()));
    }
    depths = transport.depths(task);
  }
  std::vector<double> taken_away, at_once;
  std::vector<float> depths;
};

/// Negative light alone swells, and ends when it has passed every surface in line. With what surfaces reflect on the way it has
/// no end where many stand in line, whether they are far apart beside the elements (of 0.16 m) or near.
TEST(BinTransport, NegativeLightEndsAfterTheLastSurfaceInLine) {
  for (const float spacing : {0.2F, 0.02F}) {
    const TermsInLine two(2, spacing, 30), twelve(12, spacing, 30);
    EXPECT_LT(two.taken_away[6], 1e-4) << spacing;
    EXPECT_LT(two.at_once[29], 1e-2) << spacing;
    EXPECT_GT(*std::max_element(twelve.taken_away.begin(), twelve.taken_away.end()), 5.0) << spacing;
    EXPECT_LT(twelve.taken_away[19], 1e-4) << spacing;
    EXPECT_GT(twelve.at_once[29], 1e3) << spacing;
  }
}

/// Below each sheet there are those before it and the lit square.
TEST(BinTransport, DepthsCountSurfacesInLine) {
  const TermsInLine few(2, 0.02F, 0), many(12, 0.02F, 0);
  const float most_few = *std::max_element(few.depths.begin(), few.depths.end()),
              most_many = *std::max_element(many.depths.begin(), many.depths.end());
  EXPECT_GT(most_few, 1.0F);
  EXPECT_LT(most_few, 3.0F);
  EXPECT_GT(most_many, 6.0F);
  EXPECT_LT(most_many, 14.0F);
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
