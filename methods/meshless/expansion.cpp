#include "methods/meshless/expansion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gibench::meshless {

namespace {

/// Sum of eight lanes in a fixed order.
float sum_lanes(const float (&lanes)[tree_width]) {
  return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

}  // namespace

Expansion::Expansion(const Coefficients& coefficients)
    : levels_(coefficients.hierarchy().levels()), groups_(coefficients.hierarchy().groups()) {
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
  cluster.blocks.reserve(static_cast<std::size_t>(std::count(reached.begin(), reached.end(), 1)));
  for (std::uint32_t block = 0; block < reached.size(); ++block) {
    if (reached[block] == 0) continue;
    const std::uint32_t first = begin + block * tree_width;
    cluster.blocks.push_back(make_block(coefficients, first, std::min(end, first + tree_width)));
    boxes.push_back(hierarchy.block_box(level, group, block));
  }
  cluster.tree = BoxTree(boxes);
}

Expansion::Block Expansion::make_block(const Coefficients& coefficients, std::uint32_t begin, std::uint32_t end) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  Block block{};
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
    block.red[i] = value.r, block.green[i] = value.g, block.blue[i] = value.b;
  }
  return block;
}

/// Eq. 12 and 13 and the sums of Eq. 4, eight basis functions at a time.
void Expansion::add_weights(const Block& block, const Place& at, Sums& sums) {
  const float px = at.position.x, py = at.position.y, pz = at.position.z;
  const float nx = at.normal.x, ny = at.normal.y, nz = at.normal.z;
  for (std::uint32_t i = 0; i < tree_width; ++i) {
    const float dx = px - block.position[0][i], dy = py - block.position[1][i], dz = pz - block.position[2][i];
    const float squared_ratio = std::min((dx * dx + dy * dy + dz * dz) * block.inverse_radius_squared[i], 1.0F);
    const float cosine = nx * block.normal[0][i] + ny * block.normal[1][i] + nz * block.normal[2][i];
    const float facing = cosine > least_cosine ? cosine : 0.0F;
    const float w = kernel(squared_ratio) * facing;
    sums.weight[i] += w;
    sums.red[i] += w * block.red[i];
    sums.green[i] += w * block.green[i];
    sums.blue[i] += w * block.blue[i];
  }
}

/// Counts the basis functions that cover the place and adds up the solid angles of their balls: 2π (1 − cos θ),
/// sin θ = radius / distance; half the sphere and more where the receiver is inside.
void Expansion::add_solid_angles(const Block& block, const Place& at, const Vec3& receiver, Sums& sums) {
  const float px = at.position.x, py = at.position.y, pz = at.position.z;
  const float nx = at.normal.x, ny = at.normal.y, nz = at.normal.z;
  const float rx = receiver.x, ry = receiver.y, rz = receiver.z;
  for (std::uint32_t i = 0; i < tree_width; ++i) {
    const float dx = px - block.position[0][i], dy = py - block.position[1][i], dz = pz - block.position[2][i];
    const float squared_ratio = (dx * dx + dy * dy + dz * dz) * block.inverse_radius_squared[i];
    const float cosine = nx * block.normal[0][i] + ny * block.normal[1][i] + nz * block.normal[2][i];
    const float covers = (squared_ratio < 1.0F ? 1.0F : 0.0F) * (cosine > least_cosine ? 1.0F : 0.0F);
    const float ex = rx - block.position[0][i], ey = ry - block.position[1][i], ez = rz - block.position[2][i];
    const float distance_ratio = (ex * ex + ey * ey + ez * ez) * block.inverse_radius_squared[i];
    const float cosine_squared = std::max(1.0F - 1.0F / std::max(distance_ratio, 1.0F), 0.0F);
    sums.covering[i] += covers;
    sums.solid_angle[i] += covers * 2.0F * pi * (1.0F - std::sqrt(cosine_squared));
  }
}

bool Expansion::level_value(const Sums& sums, Rgb& value) {
  const float weights = sum_lanes(sums.weight);
  if (!(weights > 0.0F)) return false;
  value = Rgb(sum_lanes(sums.red), sum_lanes(sums.green), sum_lanes(sums.blue)) / weights;
  return true;
}

Rgb Expansion::evaluate(const Place& at) const {
  Rgb sum;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    const Cluster& cluster = clusters_[level * groups_ + at.group];
    Sums sums{};
    cluster.tree.visit_point(at.position, [&](std::uint32_t block) { add_weights(cluster.blocks[block], at, sums); });
    if (Rgb value; level_value(sums, value)) sum += value;
  }
  return sum;
}

Rgb Expansion::evaluate_seen(const Place& at, const Vec3& receiver, float solid_angle, std::uint64_t& levels_used) const {
  Rgb sum;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    const Cluster& cluster = clusters_[level * groups_ + at.group];
    if (cluster.tree.empty()) continue;
    Sums sums{};
    cluster.tree.visit_point(at.position, [&](std::uint32_t block) {
      add_weights(cluster.blocks[block], at, sums);
      add_solid_angles(cluster.blocks[block], at, receiver, sums);
    });
    Rgb value;
    if (!level_value(sums, value)) continue;
    ++levels_used;
    sum += value;
    if (sum_lanes(sums.solid_angle) < solid_angle * sum_lanes(sums.covering)) break;
  }
  return sum;
}

std::size_t Expansion::bytes() const {
  std::size_t sum = clusters_.capacity() * sizeof(Cluster);
  for (const Cluster& cluster : clusters_) sum += cluster.blocks.capacity() * sizeof(Block) + cluster.tree.bytes();
  return sum;
}

}  // namespace gibench::meshless
