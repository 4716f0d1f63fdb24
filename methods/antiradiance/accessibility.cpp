#include "methods/antiradiance/accessibility.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 64;
constexpr float near_radii = 3.0F;  // of a blocker, within which it is its cell's polygons
constexpr float wide_cone = 0.35F;  // sine: a node bent more than that is opened
constexpr float coplanar = 1e-5F;   // of the distance

/// Point to disc: the limit of the disc-to-disc form for a receiver without area.
float disc_share(const Node& node, float squared, float u, float v, float m) {
  const float t = node.area / (pi * squared + node.area);
  return t * orientation_factor(u, v, m, 0.0F, t);
}

}  // namespace

void Accessibility::compute(int passes, Task& task) {
  leaves_.assign(hierarchy_.leaf_count(), {});
  std::vector<TwoSides> before;
  for (int pass = 0; pass < passes && !task.cancelled(); ++pass) {
    pull();
    before = leaves_;
    std::vector<std::uint64_t> evaluations(chunk_count(leaves_.size(), leaf_chunk), 0);
    task.parallel_chunks(leaves_.size(), leaf_chunk, [&](const ChunkRange& range) {
      for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
        const std::uint32_t element = hierarchy_.order()[leaf];
        const Disc& disc = elements_.disc(element);
        const Blocked front = blocked(disc.centre, disc.normal, element), back = blocked(disc.centre, -disc.normal, element);
        leaves_[leaf] = {1.0F - std::min(1.0F, front.share), 1.0F - std::min(1.0F, back.share)};
        evaluations[range.chunk] += front.evaluations + back.evaluations;
      }
    });
    for (const std::uint64_t count : evaluations) evaluations_ += count;
    task.progress("accessibility pass", static_cast<double>(pass + 1) / passes);
  }
  if (passes > 1)
    for (std::size_t i = 0; i < leaves_.size(); ++i)
      leaves_[i] = {0.5F * (leaves_[i].front + before[i].front), 0.5F * (leaves_[i].back + before[i].back)};
  pull();
}

void Accessibility::pull() {
  const auto nodes = hierarchy_.nodes();
  nodes_.resize(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].is_leaf()) {
      nodes_[i] = leaves_[nodes[i].begin];
      continue;
    }
    const float share = nodes[i + 1].area / nodes[i].area;
    const TwoSides &left = nodes_[i + 1], &right = nodes_[nodes[i].right];
    nodes_[i] = {left.front * share + right.front * (1.0F - share), left.back * share + right.back * (1.0F - share)};
  }
}

float Accessibility::at(const Vec3& point, const Vec3& normal, std::uint32_t own) const {
  return 1.0F - std::min(1.0F, blocked(point, normal, own).share);
}

float Accessibility::leaf_form_factor(const Node& leaf, const Vec3& point, const Vec3& normal) const {
  float sum = 0.0F;
  for (const CellPart& part : elements_.parts(hierarchy_.element(leaf))) sum += polygon_form_factor(point, normal, part.corners);
  return sum * elements_.exposed_share(hierarchy_.element(leaf));
}

Accessibility::Blocked Accessibility::blocked(const Vec3& point, const Vec3& normal, std::uint32_t own) const {
  Blocked result;
  std::array<std::uint32_t, 128> stack{};
  const auto nodes = hierarchy_.nodes();
  for (const std::uint32_t root : hierarchy_.roots()) {
    // The back of a two-sided sheet is where its front is: one of the two blocks.
    if (elements_.sheet(hierarchy_.order()[nodes[root].begin]) % 2 != 0) continue;
    std::size_t depth = 0;
    stack[depth++] = root;
    while (depth > 0) {
      const std::uint32_t index = stack[--depth];
      const Node& node = nodes[index];
      const Vec3 d = node.centre - point;
      const float squared = glm::dot(d, d), r = std::sqrt(squared);
      const float disc_reach = std::sqrt(node.area / pi);
      const float u = glm::dot(normal, d), v = -glm::dot(node.normal, d), m = glm::dot(normal, node.normal);
      const float across = std::sqrt(std::max(0.0F, 1.0F - m * m));
      const float stray = node.thickness * std::fabs(m) + (node.reach + 2.0F * disc_reach) * across;
      if (u + stray <= coplanar * (r + node.reach)) continue;
      ++result.evaluations;
      const float share = v < 0.0F ? nodes_[index].front : nodes_[index].back;
      const float bound = node.area / (pi * squared + node.area);
      const bool stands = !node.is_leaf() && bound < far_enough_ && node.cone_sine < wide_cone && r > node.reach;
      if (!node.is_leaf() && !stands && depth + 2 <= stack.size()) {
        stack[depth++] = node.right;
        stack[depth++] = index + 1;
        continue;
      }
      if (node.is_leaf() && hierarchy_.element(node) == own) continue;
      if (node.is_leaf() && (squared < near_radii * near_radii * disc_reach * disc_reach || u < stray)) {
        result.share += share * leaf_form_factor(node, point, normal);
      } else if (u > 0.0F && r > 0.0F) {
        result.share += share * disc_share(node, squared, u / r, std::fabs(v) / r, v < 0.0F ? -m : m);
      }
    }
  }
  return result;
}

}  // namespace gibench::antiradiance
