#include "methods/wavelet/closure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/effects/sealed.h"

namespace gibench::wavelet {

namespace {

constexpr std::uint64_t closure_stage = 0x77636c6f73ULL;
constexpr std::size_t leaf_chunk = 32, node_chunk = 64;
constexpr int iterations = 8;
constexpr double most_open = 1e-4;   // of all leaves' rays in a closed scene: rounding at edges
constexpr float most_raised = 1.5F;  // factor of a leaf; it is lowered as far as it takes

/// The share of a leaf's rays that meet no lit side.
float open_share(const World& world, const Elements& elements, std::uint32_t leaf, int count, std::uint64_t seed,
                 RayStream& rays) {
  RandomStream random(seed, closure_stage, leaf);
  int open = 0;
  for (int ray = 0; ray < count; ++ray) {
    const NodePoint& point = elements.points(leaf)[static_cast<std::size_t>(ray) % points_a_node];
    const float x = random.next_float(), y = random.next_float();
    if (!(point.area > 0.0F)) continue;
    const Vec3 direction = Frame(elements.element_of(leaf).normal).to_world(cosine_hemisphere({x, y}));
    const Hit hit = rays.closest_hit({elements.origin(leaf, point), 0.0F, direction});
    if (!hit || !world.sample_of_hit(hit, direction).lit_side) ++open;
  }
  return static_cast<float>(open) / static_cast<float>(count);
}

/// Leaves from which no ray goes out. A leaf's own rays miss a small opening, and light that it lets out is not to be given back:
/// there are none unless the whole scene is closed, proven or by the rays of all leaves.
std::vector<std::uint8_t> closed_leaves(const World& world, const Elements& elements, int rays, Task& task) {
  const std::span leaves = elements.leaves();
  std::vector<std::uint8_t> closed(leaves.size(), 0);
  if (rays == 0) return closed;
  std::vector<float> open(leaves.size(), 0.0F);
  task.parallel_chunks(leaves.size(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf)
      open[leaf] = open_share(world, elements, leaves[leaf], rays, task.seed(), stream);
  });
  double going_out = 0.0, all = 0.0;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    const auto area = static_cast<double>(elements.nodes()[leaves[leaf]].area);
    going_out += area * static_cast<double>(open[leaf]);
    all += area;
  }
  if (going_out > most_open * all && !is_sealed(world)) return closed;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    closed[leaf] = elements.nodes()[leaves[leaf]].area > 0.0F && !(open[leaf] > 0.0F) ? 1 : 0;
  return closed;
}

/// Means over all nodes, by area.
std::vector<float> node_means(const Elements& elements, std::span<const float> of_leaves) {
  const std::span nodes = elements.nodes();
  std::vector<float> means(nodes.size(), 1.0F);
  for (std::size_t n = nodes.size(); n-- > 0;) {
    const Node& node = nodes[n];
    if (node.is_leaf()) {
      means[n] = of_leaves[elements.leaf_of(static_cast<std::uint32_t>(n))];
      continue;
    }
    float sum = 0.0F;
    for (std::size_t c = 0; c < child_count; ++c) sum += nodes[node.first_child + c].area * means[node.first_child + c];
    if (node.area > 0.0F) means[n] = sum / node.area;
  }
  return means;
}

/// Power that the sender of a block sends into it at radiosity one, over the root of m².
float sent_by(std::span<const Node> nodes, const BlockView& block, std::span<const float> factor) {
  const Node& from = nodes[block.sender];
  if (from.is_leaf()) return block.along_sender[0] * std::sqrt(from.area) * factor[block.sender];
  float sent = 0.0F;
  for (std::size_t j = 0; j < child_count; ++j)
    sent += block.along_sender[j] * std::sqrt(nodes[from.first_child + j].area) * factor[from.first_child + j];
  return sent;
}

}  // namespace

std::vector<float> uniform_response(const Elements& elements, const Blocks& blocks, std::span<const float> factor, Task& task) {
  const std::span nodes = elements.nodes();
  std::vector<float> from_above(nodes.size(), 0.0F), own(nodes.size(), 0.0F);  // by blocks of the parent, and of a leaf itself
  task.parallel_chunks(nodes.size(), node_chunk, [&](const ChunkRange& range) {
    for (auto n = static_cast<std::uint32_t>(range.begin); n < range.end; ++n) {
      std::array<double, child_count> sum{};
      for (std::size_t b = 0; b < blocks.count_of(n); ++b) {
        const BlockView block = blocks.view(n, b);
        const float sent = sent_by(nodes, block, factor);
        for (std::size_t i = 0; i < child_count; ++i) sum[i] += static_cast<double>(block.along_receiver[i] * sent);
      }
      const auto arriving = [&](std::uint32_t node, double value) {
        const float area = nodes[node].area;
        return area > 0.0F ? static_cast<float>(value) * factor[node] / std::sqrt(area) : 0.0F;
      };
      if (nodes[n].is_leaf()) own[n] = arriving(n, sum[0]);
      else
        for (std::uint32_t i = 0; i < child_count; ++i)
          from_above[nodes[n].first_child + i] = arriving(nodes[n].first_child + i, sum[i]);
    }
  });
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].parent != none) from_above[n] += from_above[nodes[n].parent];
    own[n] += from_above[n];
  }
  std::vector<float> response;
  for (const std::uint32_t leaf : elements.leaves()) response.push_back(own[leaf]);
  return response;
}

float hold_to_sums(const World& world, const Elements& elements, int rays, Blocks& blocks, Task& task) {
  const std::span leaves = elements.leaves();
  const std::vector<std::uint8_t> closed = closed_leaves(world, elements, rays, task);
  task.count("closed_leaves", static_cast<std::uint64_t>(std::count(closed.begin(), closed.end(), 1)));
  std::vector<float> factor(leaves.size(), 1.0F), of_nodes;
  float worst = 0.0F;
  for (int iteration = 0; iteration <= iterations && !task.cancelled(); ++iteration) {
    of_nodes = node_means(elements, factor);
    const std::vector<float> response = uniform_response(elements, blocks, of_nodes, task);
    worst = 0.0F;
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
      if (!(response[leaf] > 0.0F)) continue;
      const float wanted = closed[leaf] != 0 ? 1.0F : std::min(1.0F, response[leaf]);
      worst = std::max(worst, std::fabs(wanted - response[leaf]));
      if (iteration < iterations) factor[leaf] = std::min(factor[leaf] * std::sqrt(wanted / response[leaf]), most_raised);
    }
  }
  blocks.scale(elements, of_nodes, task);
  return worst;
}

}  // namespace gibench::wavelet
