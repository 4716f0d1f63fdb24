#include "common/spaces/place_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace gibench {

namespace {

constexpr std::uint32_t large_range = 16384;  // places: below, a subtree is the work of one thread
constexpr std::uint32_t least_share = 8;      // a half of the box holds at least one in so many places

int longest_axis(const Vec3& side) { return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2; }

}  // namespace

PlaceTree::PlaceTree(std::span<const Place> places, Task& task) : order_(places.size()) {
  std::vector<Range> open = label_ranges(places);
  std::vector<Range> whole;
  while (!open.empty()) {  // level by level, until every range is small
    std::vector<Range> next;
    for (const Range& range : open) (range.size() > large_range ? next : whole).push_back(range);
    std::vector<std::uint32_t> left(next.size());
    task.parallel_chunks(next.size(), 1, [&](const ChunkRange& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) left[i] = fill(places, next[i]);
    });
    if (task.cancelled()) return;
    open.clear();
    for (std::size_t i = 0; i < next.size(); ++i) {
      const Range& range = next[i];
      visits_ += range.size();
      open.push_back({range.node + 1, range.begin, range.begin + left[i]});
      open.push_back({range.node + 2 * left[i], range.begin + left[i], range.end});
    }
  }
  std::vector<std::uint64_t> visited(whole.size());
  task.parallel_chunks(whole.size(), 16, [&](const ChunkRange& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) visited[i] = build_below(places, whole[i]);
  });
  visits_ = std::accumulate(visited.begin(), visited.end(), visits_);
}

std::vector<PlaceTree::Range> PlaceTree::label_ranges(std::span<const Place> places) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return places[a].label < places[b].label; });
  std::vector<Range> ranges;
  std::uint32_t node = 0;
  for (std::uint32_t begin = 0; begin < order_.size();) {
    std::uint32_t end = begin + 1;
    while (end < order_.size() && places[order_[end]].label == places[order_[begin]].label) ++end;
    ranges.push_back({node, begin, end});
    roots_.push_back(node);
    node += 2 * (end - begin) - 1;
    begin = end;
  }
  nodes_.resize(node);
  return ranges;
}

std::uint32_t PlaceTree::fill(std::span<const Place> places, const Range& range) {
  const auto first = order_.begin() + range.begin, last = order_.begin() + range.end;
  Vec3 low(std::numeric_limits<float>::infinity()), high = -low;
  double area = 0.0;
  for (auto i = first; i != last; ++i) {
    area += static_cast<double>(places[*i].area);
    low = glm::min(low, places[*i].position);
    high = glm::max(high, places[*i].position);
  }
  const Vec3 side = high - low;
  PlaceNode& node = nodes_[range.node];
  node = {0.5F * (low + high), 0.5F * glm::length(side), range.begin, range.end, static_cast<float>(area), 0};
  if (range.size() == 1) return 0;
  const int axis = longest_axis(side);
  const auto at = [&](std::uint32_t i) { return places[i].position[axis]; };
  const float middle = node.centre[axis];
  const auto cut = std::partition(first, last, [&](std::uint32_t i) { return at(i) < middle; });
  auto left = static_cast<std::uint32_t>(cut - first);
  const std::uint32_t least = std::max(1U, range.size() / least_share);
  if (left < least || range.size() - left < least) {
    left = range.size() / 2;
    std::nth_element(first, first + left, last,
                     [&](std::uint32_t a, std::uint32_t b) { return std::pair(at(a), a) < std::pair(at(b), b); });
  }
  node.right = range.node + 2 * left;
  return left;
}

std::uint64_t PlaceTree::build_below(std::span<const Place> places, const Range& range) {
  std::uint64_t visited = 0;
  std::vector<Range> stack{range};
  while (!stack.empty()) {
    const Range top = stack.back();
    stack.pop_back();
    visited += top.size();
    const std::uint32_t left = fill(places, top);
    if (left == 0) continue;
    stack.push_back({top.node + 2 * left, top.begin + left, top.end});
    stack.push_back({top.node + 1, top.begin, top.begin + left});
  }
  return visited;
}

}  // namespace gibench
