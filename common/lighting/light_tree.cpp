#include "common/lighting/light_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/lanes.h"

namespace gibench {

namespace {

constexpr float least_squared_distance = 1e-20F;  // m²: a point on a light without extent is not infinitely bright

/// All of them as one: of directions that differ, what their sum leaves out is spread evenly, a quarter of it, the mean of
/// max(0, cos) over the sphere.
PlacedLight united(std::span<const PlacedLight> lights, std::span<const std::uint32_t> members) {
  Vec3 low(INFINITY), high(-INFINITY);
  PlacedLight all;
  float strengths = 0.0F;
  for (const std::uint32_t member : members) {
    const PlacedLight& light = lights[member];
    low = glm::min(low, light.centre - light.radius);
    high = glm::max(high, light.centre + light.radius);
    all.directed += light.directed;
    all.even += light.even;
    strengths += glm::length(light.directed);
  }
  all.even += 0.25F * std::max(0.0F, strengths - glm::length(all.directed));
  all.centre = 0.5F * (low + high);
  for (const std::uint32_t member : members)
    all.radius = std::max(all.radius, glm::distance(all.centre, lights[member].centre) + lights[member].radius);
  return all;
}

using Members = std::span<std::uint32_t>;

/// Two halves of as many lights, apart along the longest edge of the box of their centres.
std::array<Members, 2> halves(std::span<const PlacedLight> lights, Members members) {
  Vec3 low(INFINITY), high(-INFINITY);
  for (const std::uint32_t member : members)
    low = glm::min(low, lights[member].centre), high = glm::max(high, lights[member].centre);
  const Vec3 extent = high - low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::size_t half = members.size() / 2;
  std::nth_element(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half), members.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float x = lights[a].centre[axis], y = lights[b].centre[axis];
                     return x < y || (x == y && a < b);
                   });
  return {members.first(half), members.subspan(half)};
}

double sum_of_weights(std::span<const float> weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

}  // namespace

class LightTree::Builder {
 public:
  Builder(LightTree& tree, std::span<const PlacedLight> lights) : tree_(tree), lights_(lights) {
    tree_.place_of_light_.resize(lights.size());
    std::vector<std::uint32_t> members(lights.size());
    std::iota(members.begin(), members.end(), 0U);
    if (!members.empty()) build(members, Place());
  }

 private:
  std::uint32_t build(Members members, Place place) {
    const auto node = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    tree_.place_of_node_.push_back(place);
    if (members.size() <= width) {
      tree_.nodes_[node].last = true;
      for (std::uint32_t slot = 0; slot < members.size(); ++slot) {
        tree_.place_of_light_[members[slot]] = {node, slot};
        set(node, slot, members[slot], lights_[members[slot]]);
      }
      return node;
    }
    std::vector<Members> parts{members};
    while (parts.size() < width) {
      std::vector<Members> finer;
      for (const Members part : parts)
        for (const Members half : halves(lights_, part)) finer.push_back(half);
      parts = std::move(finer);
    }
    for (std::uint32_t slot = 0; slot < width; ++slot)
      set(node, slot, build(parts[slot], {node, slot}), united(lights_, parts[slot]));
    return node;
  }

  void set(std::uint32_t node, std::uint32_t slot, std::uint32_t child, const PlacedLight& light) {
    Node& of = tree_.nodes_[node];
    of.x[slot] = light.centre.x, of.y[slot] = light.centre.y, of.z[slot] = light.centre.z;
    of.radius[slot] = light.radius;
    of.directed_x[slot] = light.directed.x, of.directed_y[slot] = light.directed.y, of.directed_z[slot] = light.directed.z;
    of.strength[slot] = glm::length(light.directed);
    of.even[slot] = light.even;
    of.child[slot] = child;
  }

  LightTree& tree_;
  std::span<const PlacedLight> lights_;
};

LightTree::LightTree(std::span<const PlacedLight> lights) { Builder(*this, lights); }

/// What each child gives: no cosine is smaller than the largest in its ball, no distance shorter than the ball's radius.
std::array<float, LightTree::width> LightTree::estimates(const Node& node, const Vec3& position, const Vec3& normal) {
  const auto load = [](const std::array<float, width>& column) { return load_lanes<Lanes>(column.data()); };
  const Lanes zero{}, x = load(node.x) - position.x, y = load(node.y) - position.y, z = load(node.z) - position.z,
                      radius = load(node.radius), strength = load(node.strength);
  const Lanes squared = larger(x * x + y * y + z * z, larger(radius * radius, all_lanes(least_squared_distance)));
  const Lanes nearness = 1.0F / square_root(squared);
  const Lanes above = larger(normal.x * x + normal.y * y + normal.z * z + radius, zero);
  const Lanes ahead =
      larger(strength * radius - load(node.directed_x) * x - load(node.directed_y) * y - load(node.directed_z) * z, zero);
  const Lanes intensity = smaller(ahead * nearness, strength) + load(node.even);
  const Lanes result = intensity * smaller(above * nearness, all_lanes(1.0F)) * nearness * nearness;
  std::array<float, width> weights;
  store_lanes(weights.data(), result);
  return weights;
}

LightTree::Choice LightTree::choose(const Vec3& position, const Vec3& normal, double fraction) const {
  if (nodes_.empty()) return {};
  double probability = 1.0;
  for (std::uint32_t node = 0;;) {
    const std::array<float, width> weights = estimates(nodes_[node], position, normal);
    const double total = sum_of_weights(weights);
    if (!(total > 0.0) || !std::isfinite(total)) return {};
    double left = fraction * total;
    std::size_t slot = 0;
    for (; slot + 1 < width && left >= static_cast<double>(weights[slot]); ++slot) left -= static_cast<double>(weights[slot]);
    while (!(weights[slot] > 0.0F)) --slot;  // past the last by rounding
    const auto weight = static_cast<double>(weights[slot]);
    probability *= weight / total;
    const std::uint32_t child = nodes_[node].child[slot];
    fraction = std::clamp(left / weight, 0.0, 0x1.fffffffffffffp-1);
    if (nodes_[node].last) return {child, static_cast<float>(probability), fraction};
    node = child;
  }
}

float LightTree::probability(std::size_t light, const Vec3& position, const Vec3& normal) const {
  double probability = 1.0;
  for (Place place = place_of_light_[light];; place = place_of_node_[place.node]) {
    const std::array<float, width> weights = estimates(nodes_[place.node], position, normal);
    const double total = sum_of_weights(weights);
    if (!(total > 0.0) || !std::isfinite(total)) return 0.0F;
    probability *= static_cast<double>(weights[place.slot]) / total;
    if (place.node == 0) return static_cast<float>(probability);
  }
}

}  // namespace gibench
