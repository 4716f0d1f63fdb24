/// Links traced by rays: the share that is free, and what is made of those that are free in part.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/exchange.h"
#include "methods/antiradiance/link_tracing.h"
#include "methods/antiradiance/refinement.h"

namespace gibench::antiradiance {
namespace {

Settings traced_settings(std::vector<std::pair<std::string, std::string>> values) {
  values.emplace_back("mode", "radiosity");
  return settings_from(Parameters(settings_schema(), values));
}

/// A small bright-side sender of many tiny elements in view, and a large element that a plate hides.
struct HiddenSender {
  HiddenSender() {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
    builder.quad("receiver", white, {{{-0.1F, 0.0F, 0.1F}, {0.1F, 0.0F, 0.1F}, {0.1F, 0.0F, -0.1F}, {-0.1F, 0.0F, -0.1F}}});
    // Seen from above: one of 1 m² on the left, behind the plate; twenty-five of 1 cm² on the right.
    std::vector<Vec3> corners;
    std::vector<std::array<std::uint32_t, 4>> faces;
    const auto add = [&](float x, float z, float size) {
      const auto first = static_cast<std::uint32_t>(corners.size());
      for (const Vec3& corner :
           {Vec3(x, 2.0F, z), Vec3(x + size, 2.0F, z), Vec3(x + size, 2.0F, z + size), Vec3(x, 2.0F, z + size)})
        corners.push_back(corner);
      faces.push_back({first, first + 1, first + 2, first + 3});
    };
    add(-1.5F, -0.5F, 1.0F);
    for (int i = 0; i < 25; ++i) add(0.5F + 0.02F * static_cast<float>(i % 5), 0.02F * static_cast<float>(i / 5), 0.01F);
    builder.object("sender", white, corners, faces);
    builder.quad("plate", white, {{{-1.7F, 1.9F, 0.7F}, {-0.3F, 1.9F, 0.7F}, {-0.3F, 1.9F, -0.7F}, {-1.7F, 1.9F, -0.7F}}}, true);
    world.emplace(builder.build("hidden sender"));
  }
  std::optional<World> world;
};

/// One link from a node over the large square and some of the small ones to one of the receiver.
struct LinkFromHidden {
  LinkFromHidden() : parts(*scene.world, traced_settings({{"elements", "20"}, {"closure_rays", "0"}, {"merge", "false"}}), task) {
    const auto node_of = [&](std::uint32_t sheet) {
      const auto nodes = parts.hierarchy.nodes();
      for (std::uint32_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].sheet == sheet) return i;
      return no_element;
    };
    const std::uint32_t receiver = node_of(0);
    sender = node_of(2);
    for (std::uint32_t i = 0; i <= parts.hierarchy.size(); ++i) links.row_begin.push_back(i <= receiver ? 0 : 1);
    links.senders.push_back({sender});
    links.factors.push_back(1.0F);
  }
  std::size_t trace(float most_partial) {
    return trace_links(*scene.world, parts.elements, parts.hierarchy, {4096, true, most_partial}, links, task).taken_apart;
  }
  HiddenSender scene;
  Task task;
  Discretisation parts;
  LinkTable links;
  std::uint32_t sender = 0;
};

TEST(LinkTracing, FindsAShareOfAreaNotOfElements) {
  LinkFromHidden made;
  EXPECT_EQ(made.trace(std::numeric_limits<float>::infinity()), 0U);
  const auto& [scene, task, parts, links, sender] = made;
  const Node& node = parts.hierarchy.nodes()[sender];
  float free = 0.0F, elements = 0.0F;
  for (std::uint32_t leaf = node.begin; leaf < node.end; ++leaf) {
    const Disc& disc = parts.elements.disc(parts.hierarchy.order()[leaf]);
    if (disc.centre.x > 0.0F) free += disc.area, elements += 1.0F;
  }
  const float share = free / node.area;
  ASSERT_GT(elements, 20.0F);
  ASSERT_LT(share, 0.01F);
  // Of 4096 rays; none of them free would take out the link.
  const float seen = links.size() == 1 ? links.factors[0] : 0.0F;
  EXPECT_NEAR(seen, share, 4.0F * std::sqrt(share / 4096.0F));
}

/// What is hidden sends nothing, and what is free is linked by itself, wholly.
TEST(LinkTracing, TakesApartWhatIsFreeInPart) {
  LinkFromHidden made;
  EXPECT_GT(made.trace(0.0F), 0U);
  ASSERT_GT(made.links.size(), 0U);
  for (std::size_t link = 0; link < made.links.size(); ++link) {
    const Node& node = made.parts.hierarchy.nodes()[made.links.senders[link].node()];
    EXPECT_LT(node.area, 0.01F * made.parts.hierarchy.nodes()[made.sender].area);
    for (std::uint32_t leaf = node.begin; leaf < node.end; ++leaf)
      EXPECT_GT(made.parts.elements.disc(made.parts.hierarchy.order()[leaf]).centre.x, 0.0F);
  }
}

/// Two squares of 1 m² that face each other over 10 m, and midway a plate that hides all that passes at x < `edge`.
struct OverAnEdge {
  explicit OverAnEdge(float edge) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
    const float s = 0.5F;
    builder.quad("receiver", white, {{{-s, 0.0F, s}, {s, 0.0F, s}, {s, 0.0F, -s}, {-s, 0.0F, -s}}});
    builder.quad("sender", white, {{{-s, 10.0F, -s}, {s, 10.0F, -s}, {s, 10.0F, s}, {-s, 10.0F, s}}});
    builder.quad("plate", white, {{{-2.0F, 5.0F, 2.0F}, {edge, 5.0F, 2.0F}, {edge, 5.0F, -2.0F}, {-2.0F, 5.0F, -2.0F}}}, true);
    world.emplace(builder.build("over an edge"));
    Task task;
    parts.emplace(*world, traced_settings({{"elements", "100"}, {"closure_rays", "0"}, {"merge", "false"}}), task);
  }
  /// What the sender gives to the receiver, m², over one link from root to root.
  double exchange(const TracingRule& rule, std::uint64_t seed, bool traced = true) const {
    const auto nodes = parts->hierarchy.nodes();
    const auto top = [&](std::uint32_t sheet) {
      std::uint32_t node = 0;
      while (nodes[node].sheet != sheet) ++node;
      return node;
    };
    LinkTable links;
    for (std::uint32_t i = 0; i <= nodes.size(); ++i) links.row_begin.push_back(i <= top(0) ? 0 : 1);
    links.senders.push_back({top(2)});
    links.factors.push_back(1.0F);
    Task task({.seed = seed, .threads = 1, .cancel = {}, .on_progress = {}});
    refine_factors(parts->elements, parts->hierarchy, true, links, task);
    if (traced) trace_links(*world, parts->elements, parts->hierarchy, rule, links, task);
    double sum = 0.0;
    for (std::size_t p = 0; p < nodes.size(); ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link)
        sum += static_cast<double>(nodes[p].area) * static_cast<double>(links.factors[link]);
    return sum;
  }
  std::optional<World> world;
  std::optional<Discretisation> parts;
};

/// Midway, segments between the squares pass at a mean of two uniform numbers: beyond `edge` with a chance of 2 (1/2 − edge)².
TEST(LinkTracing, KeepsTheFreeShareInTheMean) {
  for (const float edge : {-0.25F, 0.0F, 0.25F}) {
    const OverAnEdge made(edge);
    const double beyond = 2.0 * std::pow(0.5 - std::fabs(static_cast<double>(edge)), 2.0);
    const double share = edge < 0.0F ? 1.0 - beyond : beyond;
    for (const std::size_t most_made : {std::numeric_limits<std::size_t>::max(), std::size_t{6}, std::size_t{0}}) {
      const TracingRule rule{4, true, 0.0F, most_made};
      double sum = 0.0, squares = 0.0;
      const int seeds = 2000;
      for (int seed = 1; seed <= seeds; ++seed) {
        const double value = made.exchange(rule, static_cast<std::uint64_t>(seed)) / made.exchange(rule, 1, false);
        sum += value, squares += value * value;
      }
      const double mean = sum / seeds, error = std::sqrt((squares / seeds - mean * mean) / seeds);
      // Over 10 m form factors differ by less than 1% from one part of a square to another.
      EXPECT_NEAR(mean, share, 4.0 * error + 0.01 * share) << "edge at " << edge << ", room for " << most_made;
    }
  }
}

TEST(LinkTracing, TakesApartWithinTheRoomThereIs) {
  const World world(made::box_scene());
  const Settings rule = traced_settings({{"elements", "1000"}});
  std::vector<LinkTable> tables;
  std::vector<TracingCounts> counts;
  const auto traced = [&](std::size_t most_made, int threads) {
    Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
    const Discretisation parts(world, rule, task);
    RefinementCounts refined;
    tables.push_back(make_links(parts.hierarchy, {Facing::fronts, 0.02F}, task, refined));
    const std::size_t before = tables.back().size();
    counts.push_back(trace_links(world, parts.elements, parts.hierarchy, {4, true, 0.0F, most_made}, tables.back(), task));
    return before;
  };
  const std::size_t room = 2000;
  for (const int threads : {1, 2}) {
    const std::size_t before = traced(room, threads);
    EXPECT_LE(tables.back().size(), before + room);
  }
  EXPECT_EQ(tables[0].row_begin, tables[1].row_begin);
  EXPECT_EQ(tables[0].factors, tables[1].factors);
  EXPECT_GT(counts[0].taken_apart, 0U);
  EXPECT_GT(counts[0].left_whole, 0U);
  const std::size_t before = traced(0, 2);
  EXPECT_LE(tables.back().size(), before);
  EXPECT_EQ(counts.back().taken_apart, 0U);
}

TEST(LinkTracing, TakesApartWithinTheMemoryBudgetAndReportsIt) {
  Task task;
  const World world(made::box_scene());
  const Settings wide = traced_settings({{"elements", "1000"}});
  const Discretisation parts(world, wide, task);
  const std::size_t oracles = make_linking(world, parts, wide, Visibility::none_needed, {}, task).links.size();
  Settings narrow = wide;
  // Just enough for the oracle's links: an eighth of them is left to be made.
  narrow.memory_budget = (static_cast<double>(parts.bytes()) + 20.1 * static_cast<double>(oracles)) / (1024.0 * 1024.0);
  std::vector<std::uint64_t> taken_apart;
  for (const Settings& rule : {wide, narrow}) {
    Task own;
    const Linking linking = make_linking(world, parts, rule, Visibility::traced, {}, own);
    EXPECT_EQ(linking.tolerance, wide.tolerance);
    EXPECT_EQ(linking.warning.find("free in part") != std::string::npos, !taken_apart.empty()) << linking.warning;
    taken_apart.push_back(own.counters()["links_taken_apart"]);
  }
  EXPECT_GT(taken_apart[1], 0U);
  EXPECT_LT(taken_apart[1], taken_apart[0]);
}

/// Whose tolerance is of light, not of form factors.
TEST(LinkTracing, LeavesLinksOfTheRadiosityOracleWhole) {
  const World world(made::box_scene());
  Task task;
  const Settings rule = traced_settings({{"elements", "500"}, {"oracle", "radiosity"}});
  const Discretisation parts(world, rule, task);
  const std::vector<float> radiosity(parts.hierarchy.size(), 1.0F);
  EXPECT_GT(make_linking(world, parts, rule, Visibility::traced, radiosity, task).links.size(), 0U);
  EXPECT_EQ(task.counters()["links_taken_apart"], 0U);
  make_linking(world, parts, rule, Visibility::traced, {}, task);
  EXPECT_GT(task.counters()["links_taken_apart"], 0U);
}

}  // namespace
}  // namespace gibench::antiradiance
