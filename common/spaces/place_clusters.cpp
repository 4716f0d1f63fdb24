#include "common/spaces/place_clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/spaces/place_tree.h"

namespace gibench {

namespace {

constexpr float right_angle_within = 0.25F, any_angle_within = 0.0625F;  // of the radius of the cut
constexpr int most_halvings = 40, bisections = 10;

/// Cuts of the trees of places.
class TreeCut {
 public:
  TreeCut(std::span<const Place> places, const PlaceTree& tree, float least_cosine)
      : places_(places),
        tree_(tree),
        cosines_{least_cosine, std::min(least_cosine, 0.0F)},
        members_(tree.order().begin(), tree.order().end()),
        parts_(tree.nodes().size()) {}

  /// Metres: the ball of this size that is as large as the largest tree, by radius and by area.
  float largest_reach() const {
    float largest = 0.0F;
    for (const std::uint32_t root : tree_.roots()) {
      const PlaceNode& node = tree_.nodes()[root];
      largest = std::max({largest, node.radius, std::sqrt(node.area / (4.0F * pi))});
    }
    return largest;
  }

  /// Clusters of the cut at this radius; counts no further than just beyond `most`.
  std::size_t count(float radius, std::size_t most) {
    std::size_t clusters = 0;
    cut(radius, [&](std::uint32_t node, Strictness strictness) {
      clusters += part_count(node, strictness);
      return clusters <= most;
    });
    return clusters;
  }

  std::vector<std::uint32_t> clusters(float radius) {
    std::vector<std::uint32_t> cluster_of_place(places_.size());
    std::uint32_t clusters = 0;
    cut(radius, [&](std::uint32_t node, Strictness strictness) {
      part(node, strictness, [&](std::span<const std::uint32_t> members) {
        for (const std::uint32_t member : members) cluster_of_place[member] = clusters;
        ++clusters;
      });
      return true;
    });
    return cluster_of_place;
  }

  std::uint64_t visits() const { return visits_; }

 private:
  enum class Strictness : std::uint8_t { strict, relaxed, none };

  /// By radius and area: the vertices of one corner lie together as well, but stand for more than a crumb does.
  static Strictness strictness_of(const PlaceNode& node, float radius) {
    const auto is_within = [&](float share) {
      const float reach = share * radius;
      return node.radius <= reach && node.area <= 4.0F * pi * reach * reach;
    };
    return node.is_leaf() || is_within(any_angle_within) ? Strictness::none
           : is_within(right_angle_within)               ? Strictness::relaxed
                                                         : Strictness::strict;
  }

  /// Calls visit for the highest nodes within the radius, from left to right, while it says true.
  template <class Visit>
  void cut(float radius, const Visit& visit) {
    std::vector<std::uint32_t> stack(tree_.roots().rbegin(), tree_.roots().rend());
    while (!stack.empty()) {
      const std::uint32_t index = stack.back();
      stack.pop_back();
      ++visits_;
      const PlaceNode& node = tree_.nodes()[index];
      if (node.radius > radius) {  // so it is no leaf
        stack.push_back(node.right);
        stack.push_back(index + 1);
      } else if (!visit(index, strictness_of(node, radius))) {
        return;
      }
    }
  }

  std::size_t part_count(std::uint32_t node, Strictness strictness) {
    if (strictness == Strictness::none) return 1;
    std::uint32_t& known = parts_[node][static_cast<std::size_t>(strictness)];
    if (known == 0) part(node, strictness, [&](std::span<const std::uint32_t>) { ++known; });
    return known;
  }

  /// Calls each(members) for the parts of a node whose normals keep together.
  template <class Each>
  void part(std::uint32_t node, Strictness strictness, const Each& each) {
    const PlaceNode& whole = tree_.nodes()[node];
    const std::span<std::uint32_t> members = std::span(members_).subspan(whole.begin, whole.end - whole.begin);
    visits_ += members.size();
    // From the tree's order each time: the cuts before may have parted a larger node, and moved members from one end of it to the
    // other.
    std::copy_n(tree_.order().begin() + whole.begin, members.size(), members.begin());
    if (strictness == Strictness::none) return each(members);
    part_members(members, cosines_[static_cast<std::size_t>(strictness)], each);
  }

  template <class Each>
  void part_members(std::span<std::uint32_t> members, float least_cosine, const Each& each) {
    if (members.size() == 1 || keep_together(members, least_cosine)) return each(members);
    Vec3 low(std::numeric_limits<float>::infinity()), high = -low;
    for (const std::uint32_t member : members) {
      low = glm::min(low, places_[member].normal);
      high = glm::max(high, places_[member].normal);
    }
    const Vec3 spread = high - low;
    const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    const float middle = 0.5F * (low[axis] + high[axis]);
    const auto middle_at = std::stable_partition(members.begin(), members.end(),
                                                 [&](std::uint32_t member) { return places_[member].normal[axis] < middle; });
    const auto left = static_cast<std::size_t>(middle_at - members.begin());
    visits_ += members.size();
    if (left == 0 || left == members.size()) return each(members);  // alike but for rounding
    part_members(members.first(left), least_cosine, each);
    part_members(members.subspan(left), least_cosine, each);
  }

  bool keep_together(std::span<const std::uint32_t> members, float least_cosine) const {
    constexpr float rounding = 1e-5F;
    Vec3 sum(0.0F), unweighted(0.0F);
    for (const std::uint32_t member : members) {
      sum += places_[member].area * places_[member].normal;
      unweighted += places_[member].normal;
    }
    if (!(glm::length(sum) > 0.0F)) sum = unweighted;
    const float length = glm::length(sum);
    if (!(length > 0.0F)) return least_cosine <= -1.0F;
    return std::ranges::all_of(members, [&](std::uint32_t member) {
      return glm::dot(places_[member].normal, sum) >= (least_cosine - rounding) * length;
    });
  }

  std::span<const Place> places_;
  const PlaceTree& tree_;
  std::array<float, 2> cosines_;
  std::vector<std::uint32_t> members_;
  std::vector<std::array<std::uint32_t, 2>> parts_;  ///< of every node, strict and relaxed; 0: not yet counted
  std::uint64_t visits_ = 0;
};

/// The smallest radius that is found to leave at most `most` clusters.
float smallest_radius(TreeCut& cut, std::size_t most) {
  const float all_together = 1.001F * cut.largest_reach() / any_angle_within;  // one cluster for each label
  float high = all_together, low = 0.0F;
  for (int i = 0; i < most_halvings && low == 0.0F; ++i) {
    const float half = 0.5F * high;
    (cut.count(half, most) <= most ? high : low) = half;
  }
  for (int i = 0; i < bisections; ++i) {
    const float middle = 0.5F * (low + high);
    (cut.count(middle, most) <= most ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::vector<std::uint32_t> cluster_places(std::span<const Place> places, const ClusterLimits& limits, Task& task) {
  std::vector<std::uint32_t> cluster_of_place(places.size());
  std::iota(cluster_of_place.begin(), cluster_of_place.end(), 0U);
  if (places.size() <= limits.most_clusters) return cluster_of_place;
  const PlaceTree tree(places, task);
  if (task.cancelled()) return cluster_of_place;
  TreeCut cut(places, tree, limits.least_cosine);
  cluster_of_place = cut.clusters(smallest_radius(cut, limits.most_clusters));
  task.count("cluster_visits", tree.visits() + cut.visits());
  return cluster_of_place;
}

std::size_t cluster_count(std::span<const std::uint32_t> cluster_of_place) {
  return cluster_of_place.empty() ? 0 : std::size_t{*std::ranges::max_element(cluster_of_place)} + 1;
}

}  // namespace gibench
