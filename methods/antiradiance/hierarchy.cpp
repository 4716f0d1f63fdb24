#include "methods/antiradiance/hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gibench::antiradiance {

namespace {

constexpr std::size_t fill_chunk = 1024;
constexpr std::uint32_t fewest_of_a_split = 16;  // one part in so many: a lopsided split is made at the median instead

/// Place and normal in one vector: what a node is split by.
struct Traits {
  float normal_scale;
  float of(const Disc& disc, int axis) const { return axis < 3 ? disc.centre[axis] : disc.normal[axis - 3] * normal_scale; }
};

struct Spread {
  int axis = 0;
  float low = 0.0F, high = 0.0F;
};

Spread widest(const Elements& elements, std::span<const std::uint32_t> members) {
  std::array<float, 6> low{}, high{};
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  const Traits unit{1.0F};
  for (const std::uint32_t member : members)
    for (int axis = 0; axis < 6; ++axis) {
      const float x = unit.of(elements.disc(member), axis);
      const auto a = static_cast<std::size_t>(axis);
      low[a] = std::min(low[a], x), high[a] = std::max(high[a], x);
    }
  const float extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  Spread best;
  float largest = -1.0F;
  for (int axis = 0; axis < 6; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    // Normals that differ by one unit (60 degrees) are parted like places across the whole node.
    const float size = (high[a] - low[a]) * (axis < 3 ? 1.0F : std::max(extent, std::numeric_limits<float>::min()));
    if (size > largest) largest = size, best = {axis, low[a], high[a]};
  }
  return best;
}

/// sin(a + b), 1 from a right angle on.
float sine_of_sum(float sine_a, float sine_b) {
  const float cosine_a = std::sqrt(std::max(0.0F, 1.0F - sine_a * sine_a)),
              cosine_b = std::sqrt(std::max(0.0F, 1.0F - sine_b * sine_b));
  if (cosine_a * cosine_b <= sine_a * sine_b) return 1.0F;
  return std::min(1.0F, sine_a * cosine_b + cosine_a * sine_b);
}

/// The larger of the two children's cones as seen from the parent's normal.
float cone_of(const Vec3& normal, const Node& child) {
  const float cosine = glm::dot(normal, child.normal);
  if (cosine <= 0.0F || child.cone_sine >= 1.0F) return 1.0F;
  const float sine = std::min(1.0F, glm::length(glm::cross(normal, child.normal)));
  return sine_of_sum(sine, child.cone_sine);
}

float thickness_of(const Node& node, const Node& child) {
  const Vec3 offset = child.centre - node.centre;
  const float across = std::min(1.0F, glm::length(glm::cross(node.normal, child.normal)));
  return std::fabs(glm::dot(node.normal, offset)) + child.thickness + child.reach * across;
}

}  // namespace

Hierarchy::Hierarchy(const Elements& elements, std::span<const std::uint32_t> spaces, Task& task, bool sheets_apart) {
  leaf_of_element_.assign(elements.size(), no_element);
  for (std::uint32_t element = 0; element < elements.size(); ++element)
    if (elements.disc(element).area > 0.0F) order_.push_back(element);
  const auto key = [&](std::uint32_t element) {
    return TreeKey{spaces.empty() ? 0U : spaces[element], kind_of(elements, element),
                   sheets_apart ? elements.sheet(element) : 0U};
  };
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); };
  if (!std::is_sorted(order_.begin(), order_.end(), before)) std::stable_sort(order_.begin(), order_.end(), before);
  const std::vector<std::vector<std::uint32_t>> levels = split_all(elements, key, task);
  leaf_nodes_.assign(order_.size(), 0);
  if (task.cancelled()) return;
  for (std::size_t level = levels.size(); level-- > 0;)
    task.parallel_chunks(levels[level].size(), fill_chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) fill(elements, levels[level][i]);
    });
}

Hierarchy::Kind Hierarchy::kind_of(const Elements& elements, std::uint32_t element) {
  if (elements.black_back(element)) return Kind::one_sided;
  return elements.sheet(element) % 2 == 0 ? Kind::front : Kind::back;
}

/// Level by level: the ranges of a level are disjoint. A subtree of m leaves has 2m − 1 nodes, so that every node knows its
/// number before its children are made. Returns the nodes of every level.
std::vector<std::vector<std::uint32_t>> Hierarchy::split_all(const Elements& elements,
                                                             const std::function<TreeKey(std::uint32_t)>& key, Task& task) {
  std::vector<std::vector<std::uint32_t>> levels;
  std::vector<Range> level, next;
  std::uint32_t nodes = 0;
  for (std::uint32_t begin = 0; begin < order_.size();) {
    const TreeKey shared = key(order_[begin]);
    std::uint32_t end = begin;
    while (end < order_.size() && key(order_[end]) == shared) ++end;
    level.push_back({nodes, begin, end});
    roots_.push_back(nodes);
    root_spaces_.push_back(shared.space);
    root_kinds_.push_back(shared.kind);
    nodes += 2 * (end - begin) - 1;
    begin = end;
  }
  nodes_.resize(nodes);
  while (!level.empty() && !task.cancelled()) {
    next.assign(2 * level.size(), {0, 0, 0});
    std::vector<std::uint32_t>& numbers = levels.emplace_back(level.size());
    const std::size_t chunk = std::max<std::size_t>(1, level.size() / 64);
    task.parallel_chunks(level.size(), chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const Range& whole = level[i];
        numbers[i] = whole.node;
        Node& node = nodes_[whole.node];
        node.begin = whole.begin, node.end = whole.end;
        if (whole.end - whole.begin < 2) continue;
        const std::uint32_t middle = split(elements, whole);
        node.right = whole.node + 2 * (middle - whole.begin);
        next[2 * i] = {whole.node + 1, whole.begin, middle};
        next[2 * i + 1] = {node.right, middle, whole.end};
      }
    });
    std::erase_if(next, [](const Range& range) { return range.begin == range.end; });
    level.swap(next);
  }
  return levels;
}

std::uint32_t Hierarchy::split(const Elements& elements, const Range& range) {
  const std::span<std::uint32_t> members = std::span(order_).subspan(range.begin, range.end - range.begin);
  const Spread spread = widest(elements, members);
  const Traits traits{1.0F};
  const float middle = 0.5F * (spread.low + spread.high);
  const auto at = std::stable_partition(members.begin(), members.end(), [&](std::uint32_t member) {
    return traits.of(elements.disc(member), spread.axis) < middle;
  });
  const auto count = static_cast<std::uint32_t>(members.size());
  const auto left = static_cast<std::uint32_t>(at - members.begin());
  if (std::min(left, count - left) * fewest_of_a_split >= count) return range.begin + left;
  const auto half = members.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(members.begin(), half, members.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float x = traits.of(elements.disc(a), spread.axis), y = traits.of(elements.disc(b), spread.axis);
    return x != y ? x < y : a < b;
  });
  return range.begin + count / 2;
}

/// From its element, or from its children, which are filled before.
void Hierarchy::fill(const Elements& elements, std::uint32_t index) {
  Node& node = nodes_[index];
  if (node.is_leaf()) {
    const std::uint32_t element = order_[node.begin];
    const Disc& disc = elements.disc(element);
    node.centre = disc.centre, node.normal = disc.normal, node.area = disc.area;
    node.sheet = elements.sheet(element);
    node.black_back = elements.black_back(element);
    leaf_nodes_[node.begin] = index;
    leaf_of_element_[element] = node.begin;
    return;
  }
  const Node &left = nodes_[index + 1], &right = nodes_[node.right];
  node.area = left.area + right.area;
  const float share = left.area / node.area;
  node.centre = left.centre * share + right.centre * (1.0F - share);
  const Vec3 normal = left.normal * share + right.normal * (1.0F - share);
  const float length = glm::length(normal);
  node.normal = length > 1e-6F ? normal / length : left.normal;
  node.sheet = left.sheet == right.sheet ? left.sheet : several_sheets;
  node.black_back = left.black_back;
  node.cone_sine = std::max(cone_of(node.normal, left), cone_of(node.normal, right));
  node.reach =
      std::max(glm::length(left.centre - node.centre) + left.reach, glm::length(right.centre - node.centre) + right.reach);
  node.thickness = std::max(thickness_of(node, left), thickness_of(node, right));
}

/// Spaces stand one after the other.
std::span<const std::uint32_t> Hierarchy::roots_beside(std::size_t root) const {
  const auto [first, last] = std::equal_range(root_spaces_.begin(), root_spaces_.end(), root_spaces_[root]);
  return std::span(roots_).subspan(static_cast<std::size_t>(first - root_spaces_.begin()),
                                   static_cast<std::size_t>(last - first));
}

const Node& Hierarchy::leaf_by_area(std::uint32_t node, float u) const {
  while (!nodes_[node].is_leaf()) {
    const float left = nodes_[node + 1].area / nodes_[node].area;
    if (u < left) node += 1, u /= left;
    else node = nodes_[node].right, u = left < 1.0F ? (u - left) / (1.0F - left) : 0.0F;
  }
  return nodes_[node];
}

std::size_t Hierarchy::bytes() const {
  return nodes_.capacity() * sizeof(Node) + (roots_.capacity() + root_spaces_.capacity() + order_.capacity() +
                                             leaf_nodes_.capacity() + leaf_of_element_.capacity()) *
                                                sizeof(std::uint32_t);
}

}  // namespace gibench::antiradiance
