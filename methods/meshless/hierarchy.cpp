#include "methods/meshless/hierarchy.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gibench::meshless {

namespace {

constexpr std::size_t radius_chunk = 512;  // points
constexpr float smallest_radius = 4e-3F;   // in disc radii: points that coincide over a corner

/// The k smallest squared distances met so far, below a bound.
class NearestDistances {
 public:
  NearestDistances(int count, float bound) : wanted_(count), bound_(bound) {}
  /// What a distance must stay under to be of interest; the answer once all points have been met.
  float limit() const { return found_ < wanted_ ? bound_ : squared_[static_cast<std::size_t>(found_ - 1)]; }
  void add(float distance_squared) {
    if (!(distance_squared < limit())) return;
    int at = found_ < wanted_ ? found_++ : found_ - 1;
    for (; at > 0 && squared_[static_cast<std::size_t>(at - 1)] > distance_squared; --at)
      squared_[static_cast<std::size_t>(at)] = squared_[static_cast<std::size_t>(at - 1)];
    squared_[static_cast<std::size_t>(at)] = distance_squared;
  }

 private:
  int wanted_, found_ = 0;
  float bound_;
  std::array<float, static_cast<std::size_t>(most_neighbours)> squared_{};
};

}  // namespace

Hierarchy::Hierarchy(Placement placement, std::uint32_t groups, const Settings& settings, Task& task)
    : levels_(static_cast<std::uint32_t>(placement.points.size())), groups_(groups) {
  std::size_t total = 0;
  for (const auto& level : placement.points)
    for (const auto& group : level) total += group.size();
  positions_.reserve(total);
  normals_.reserve(total);
  sides_.reserve(total);
  radii_.assign(total, 0.0F);
  cluster_begin_.push_back(0);
  double disc_radius = placement.radius;
  for (std::uint32_t level = 0; level < levels_; ++level, disc_radius *= 0.5) {
    for (std::uint32_t group = 0; group < groups_; ++group) {
      append(std::exchange(placement.points[level][group], {}));
      cluster_begin_.push_back(static_cast<std::uint32_t>(positions_.size()));
      trees_.push_back(make_tree(level, group));
      find_radii(level, group, settings, static_cast<float>(disc_radius), task);
      trees_.back() = make_tree(level, group);
    }
    task.progress("find radii", 0.7 + 0.3 * (level + 1) / levels_);
  }
}

void Hierarchy::append(const std::vector<DiscPoint>& points) {
  std::vector<Vec3> positions;
  positions.reserve(points.size());
  for (const DiscPoint& point : points) positions.push_back(point.position);
  for (std::uint32_t i : compact_order(positions)) {
    positions_.push_back(points[i].position);
    normals_.push_back(pack_normal(points[i].normal));
    sides_.push_back(points[i].side.triangle << 1 | (points[i].side.front ? 0U : 1U));
  }
}

void Hierarchy::find_radii(std::uint32_t level, std::uint32_t group, const Settings& settings, float disc_radius, Task& task) {
  const float largest_radius = static_cast<float>(settings.radius_limit) * disc_radius;
  const std::uint32_t begin = cluster_begin(level, group), end = static_cast<std::uint32_t>(positions_.size());
  const BoxTree& blocks = trees_.back();
  std::vector<Vec3> normals(end - begin);
  for (std::uint32_t point = begin; point < end; ++point) normals[point - begin] = normal(point);
  task.parallel_chunks(end - begin, radius_chunk, [&](const ChunkRange& range) {
    for (std::uint32_t i = static_cast<std::uint32_t>(range.begin); i < range.end; ++i) {
      NearestDistances nearest(settings.neighbours, largest_radius * largest_radius);
      blocks.visit_nearest(
          positions_[begin + i], [&] { return nearest.limit(); },
          [&](std::uint32_t block) {
            const std::uint32_t last = std::min(end - begin, (block + 1) * tree_width);
            for (std::uint32_t other = block * tree_width; other < last; ++other) {
              const Vec3 apart = positions_[begin + other] - positions_[begin + i];
              const float distance_squared = glm::dot(apart, apart);
              if (other == i || !(distance_squared < nearest.limit())) continue;
              if (glm::dot(normals[i], normals[other]) > least_cosine) nearest.add(distance_squared);
            }
          });
      radii_[begin + i] = std::max(std::sqrt(nearest.limit()), smallest_radius * disc_radius);
    }
  });
}

Box Hierarchy::block_box(std::uint32_t level, std::uint32_t group, std::uint32_t block) const {
  const std::uint32_t begin = cluster_begin(level, group) + block * tree_width;
  const std::uint32_t end = std::min(cluster_begin(level, group) + (block + 1) * tree_width, cluster_end(level, group));
  Box box;
  for (std::uint32_t point = begin; point < end; ++point) box.add(positions_[point], radii_[point]);
  return box;
}

BoxTree Hierarchy::make_tree(std::uint32_t level, std::uint32_t group) const {
  const std::uint32_t count = cluster_end(level, group) - cluster_begin(level, group);
  std::vector<Box> boxes((count + tree_width - 1) / tree_width);
  for (std::uint32_t block = 0; block < boxes.size(); ++block) boxes[block] = block_box(level, group, block);
  return BoxTree(boxes);
}

std::uint32_t Hierarchy::level_of(std::uint32_t point) const {
  std::uint32_t level = 0;
  while (point >= level_begin(level + 1)) ++level;
  return level;
}

std::uint32_t Hierarchy::group_of(std::uint32_t point) const {
  const auto after = std::upper_bound(cluster_begin_.begin(), cluster_begin_.end(), point);
  return static_cast<std::uint32_t>(after - cluster_begin_.begin() - 1) % groups_;
}

std::size_t Hierarchy::bytes() const {
  std::size_t sum = cluster_begin_.capacity() * sizeof(std::uint32_t) + positions_.capacity() * sizeof(Vec3) +
                    radii_.capacity() * sizeof(float) + normals_.capacity() * sizeof(std::uint32_t) +
                    sides_.capacity() * sizeof(std::uint32_t) + coarsest_shares_.capacity() * sizeof(double) +
                    cuts_.capacity() * sizeof(Cut);
  for (const BoxTree& tree : trees_) sum += sizeof(BoxTree) + tree.bytes();
  return sum;
}

}  // namespace gibench::meshless
