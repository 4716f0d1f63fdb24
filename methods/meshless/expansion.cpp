#include "methods/meshless/expansion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gibench::meshless {

namespace {

constexpr std::size_t lanes_of_a_cut = 4;

}  // namespace

Expansion::Expansion(const Coefficients& coefficients)
    : levels_(coefficients.hierarchy().levels()), groups_(coefficients.hierarchy().groups()), channels_(coefficients.channels()) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  const std::vector<std::uint32_t> points = coefficients.sorted_points();
  clusters_.reserve(std::size_t{levels_} * groups_);
  auto begin = points.begin();
  for (std::uint32_t level = 0; level < levels_; ++level)
    for (std::uint32_t group = 0; group < groups_; ++group) {
      const auto end = std::lower_bound(begin, points.end(), hierarchy.cluster_end(level, group));
      clusters_.emplace_back();
      add_cluster(coefficients, level, group, {begin, end});
      begin = end;
    }
}

/// Keeps the blocks that the support of any of the points reaches: elsewhere the level is zero.
void Expansion::add_cluster(const Coefficients& coefficients, std::uint32_t level, std::uint32_t group,
                            const std::vector<std::uint32_t>& points) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  const std::uint32_t begin = hierarchy.cluster_begin(level, group), end = hierarchy.cluster_end(level, group);
  std::vector<std::uint8_t> reached((end - begin + tree_width - 1) / tree_width, 0);
  for (std::uint32_t point : points)
    if (!is_black(coefficients[point]))
      hierarchy.tree(level, group).visit_cube(hierarchy.position(point), hierarchy.radius(point), [&](std::uint32_t block) {
        reached[block] = 1;
      });
  Cluster& cluster = clusters_.back();
  std::vector<Box> boxes;
  const auto count = static_cast<std::size_t>(std::count(reached.begin(), reached.end(), 1));
  cluster.blocks.reserve(count);
  cluster.values.reserve(count * static_cast<std::size_t>(channels_));
  for (std::uint32_t block = 0; block < reached.size(); ++block) {
    if (reached[block] == 0) continue;
    const std::uint32_t first = begin + block * tree_width;
    add_block(coefficients, first, std::min(end, first + tree_width), cluster);
    boxes.push_back(hierarchy.block_box(level, group, block));
  }
  cluster.tree = BoxTree(boxes);
}

void Expansion::add_block(const Coefficients& coefficients, std::uint32_t begin, std::uint32_t end, Cluster& cluster) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  Block block{};
  Lanes values[3]{};
  for (std::uint32_t i = 0; i < tree_width; ++i) {
    block.inverse_radius_squared[i] = std::numeric_limits<float>::max();
    if (begin + i >= end) continue;
    const std::uint32_t point = begin + i;
    const Vec3 normal = hierarchy.normal(point);
    for (int axis = 0; axis < 3; ++axis) {
      block.position[axis][i] = hierarchy.position(point)[axis];
      block.normal[axis][i] = normal[axis];
    }
    block.inverse_radius_squared[i] = 1.0F / (hierarchy.radius(point) * hierarchy.radius(point));
    const Rgb value = coefficients[point];
    for (int channel = 0; channel < 3; ++channel) values[channel][i] = value[channel];
  }
  cluster.blocks.push_back(block);
  if (begin < end && hierarchy.is_cut(hierarchy.level_of(begin))) add_cuts(hierarchy, begin, end, cluster);
  cluster.values.insert(cluster.values.end(), values, values + coefficients.channels());
}

void Expansion::add_cuts(const Hierarchy& hierarchy, std::uint32_t begin, std::uint32_t end, Cluster& cluster) {
  for (std::size_t which = 0; which < cuts_of_a_function; ++which) {
    Lanes plane[lanes_of_a_cut]{};
    for (std::uint32_t i = 0; begin + i < end; ++i) {
      const Cut& cut = hierarchy.cut(begin + i, which);
      for (int axis = 0; axis < 3; ++axis) plane[axis][i] = cut.normal[axis];
      plane[3][i] = cut.offset;
    }
    cluster.cuts.insert(cluster.cuts.end(), plane, plane + lanes_of_a_cut);
  }
}

/// Squared distances in units of the radii.
Lanes Expansion::squared_ratio(const Block& block, const Vec3& position) {
  const Lanes x = position.x - block.position[0], y = position.y - block.position[1], z = position.z - block.position[2];
  return (x * x + y * y + z * z) * block.inverse_radius_squared;
}

Lanes Expansion::facing(const Cluster& cluster, std::uint32_t index, const Place& at) {
  const Block& block = cluster.blocks[index];
  Lanes made = at.normal.x * block.normal[0] + at.normal.y * block.normal[1] + at.normal.z * block.normal[2];
  if (cluster.cuts.empty()) return made;
  const Lanes* plane = &cluster.cuts[cuts_of_a_function * lanes_of_a_cut * index];
  for (std::size_t which = 0; which < cuts_of_a_function; ++which, plane += lanes_of_a_cut) {
    const Lanes along = at.position.x * plane[0] + at.position.y * plane[1] + at.position.z * plane[2];
    made = along > plane[3] ? made : Lanes{};
  }
  return made;
}

/// Eq. 12 and 13 and the sums of Eq. 4, eight basis functions at a time.
template <int channels>
void Expansion::Sums::add_weights(const Lanes* values, const Lanes& squared_ratio, const Lanes& cosine) {
  const Lanes ratio = smaller(all_lanes(1.0F), squared_ratio);
  const Lanes kernel = ratio * (2.0F * square_root(ratio) - 3.0F) + 1.0F;
  const Lanes w = cosine > least_cosine ? kernel * cosine : Lanes{};
  weight += w;
  for (int channel = 0; channel < channels; ++channel) colour[channel] += w * values[channel];
}

/// Counts the basis functions that cover the place and adds up the solid angles of their balls: 2π (1 − cos θ),
/// sin θ = radius / distance; the half sphere where the receiver is inside.
void Expansion::Sums::add_solid_angles(const Block& block, const Vec3& receiver, const Lanes& squared_ratio,
                                       const Lanes& cosine) {
  const Lanes distance_ratio = larger(all_lanes(1.0F), Expansion::squared_ratio(block, receiver));
  const Lanes angle = 2.0F * pi * (1.0F - square_root(1.0F - 1.0F / distance_ratio));
  const LaneMask covers = (squared_ratio < 1.0F) & (cosine > least_cosine);
  covering += covers ? all_lanes(1.0F) : Lanes{};
  solid_angle += covers ? angle : Lanes{};
}

template <int channels>
bool Expansion::Sums::level_value(Rgb& value) const {
  const float weights = sum_of(weight);
  if (!(weights > 0.0F)) return false;
  if constexpr (channels == 1) value = Rgb(sum_of(colour[0]) / weights);
  else value = Rgb(sum_of(colour[0]), sum_of(colour[1]), sum_of(colour[2])) / weights;
  return true;
}

LaneMask Expansion::counting(const Cluster& cluster, std::uint32_t block) const {
  const auto channels = static_cast<std::size_t>(channels_);
  LaneMask any = cluster.values[channels * block] != 0.0F;
  for (std::size_t channel = 1; channel < channels; ++channel) any |= cluster.values[channels * block + channel] != 0.0F;
  return any;
}

Rgb Expansion::evaluate(const Place& at) const { return channels_ == 1 ? evaluate_channels<1>(at) : evaluate_channels<3>(at); }

Rgb Expansion::evaluate_seen(const Place& at, const Vec3& receiver, float solid_angle, std::uint64_t& levels_used) const {
  return channels_ == 1 ? evaluate_channels_seen<1>(at, receiver, solid_angle, levels_used)
                        : evaluate_channels_seen<3>(at, receiver, solid_angle, levels_used);
}

template <int channels>
Rgb Expansion::evaluate_channels(const Place& at) const {
  Rgb sum;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    const Cluster& cluster = clusters_[level * groups_ + at.group];
    Sums sums;
    cluster.tree.visit_point(at.position, [&](std::uint32_t index) {
      const Block& block = cluster.blocks[index];
      sums.add_weights<channels>(&cluster.values[std::size_t{channels} * index], squared_ratio(block, at.position),
                                 facing(cluster, index, at));
    });
    if (Rgb value; sums.level_value<channels>(value)) sum += value;
  }
  return sum;
}

template <int channels>
Rgb Expansion::evaluate_channels_seen(const Place& at, const Vec3& receiver, float solid_angle,
                                      std::uint64_t& levels_used) const {
  Rgb sum;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    const Cluster& cluster = clusters_[level * groups_ + at.group];
    if (cluster.tree.empty()) continue;
    Sums sums;
    cluster.tree.visit_point(at.position, [&](std::uint32_t index) {
      const Block& block = cluster.blocks[index];
      const Lanes ratio = squared_ratio(block, at.position), facing = Expansion::facing(cluster, index, at);
      sums.add_weights<channels>(&cluster.values[std::size_t{channels} * index], ratio, facing);
      sums.add_solid_angles(block, receiver, ratio, facing);
    });
    Rgb value;
    if (!sums.level_value<channels>(value)) continue;
    ++levels_used;
    sum += value;
    if (sum_of(sums.solid_angle) < solid_angle * sum_of(sums.covering)) break;
  }
  return sum;
}

std::size_t Expansion::bytes() const {
  std::size_t sum = clusters_.capacity() * sizeof(Cluster);
  for (const Cluster& cluster : clusters_)
    sum += cluster.blocks.capacity() * sizeof(Block) + cluster.values.capacity() * sizeof(Lanes) +
           cluster.cuts.capacity() * sizeof(Lanes) + cluster.tree.bytes();
  return sum;
}

}  // namespace gibench::meshless
