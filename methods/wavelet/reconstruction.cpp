#include "methods/wavelet/reconstruction.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <tuple>

#include "common/core/disjoint_sets.h"
#include "common/finite_elements/grouped.h"

namespace gibench::wavelet {

namespace {

constexpr float least_cosine = 0.766F;  // of 40 degrees, between leaves that share corners
constexpr float raised = 0.1F;          // above an edge, of the leaves' size, where something may stand in the way
constexpr std::size_t edge_chunk = 256, corner_chunk = 256;
constexpr int corrections = 2;

std::array<std::uint32_t, 3> bits_of(const Vec3& position) {
  const Vec3 no_negative_zero = position + Vec3(0.0F);
  return {std::bit_cast<std::uint32_t>(no_negative_zero.x), std::bit_cast<std::uint32_t>(no_negative_zero.y),
          std::bit_cast<std::uint32_t>(no_negative_zero.z)};
}

/// The two numbers of the unit square at a point of a flat convex quad (Newton's method: a leaf is nearly a parallelogram).
Vec2 inverse_bilinear(const Patch& quad, const Vec3& point) {
  const auto& [a, b, c, d] = quad.corners;
  Vec2 u(0.5F);
  for (int step = 0; step < 4; ++step) {
    const Vec3 off = point - quad.at(u);
    const Vec3 along = (1.0F - u.y) * (b - a) + u.y * (c - d), up = (1.0F - u.x) * (d - a) + u.x * (c - b);
    const float aa = glm::dot(along, along), uu = glm::dot(up, up), au = glm::dot(along, up), det = aa * uu - au * au;
    if (!(det > 0.0F)) break;
    const float ra = glm::dot(along, off), ru = glm::dot(up, off);
    u += Vec2(uu * ra - au * ru, aa * ru - au * ra) / det;
    u = glm::clamp(u, Vec2(0.0F), Vec2(1.0F));
  }
  return u;
}

}  // namespace

class Reconstruction::Maker {
 public:
  Maker(const World& world, const Elements& elements, bool looks, Task& task, Reconstruction& result)
      : world_(world), elements_(elements), result_(result), leaves_(elements.leaves()), joined_(leaves_.size() * child_count) {
    result_.is_used_.resize(leaves_.size());
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) result_.is_used_[leaf] = node(leaf).area > 0.0F ? 1 : 0;
    number_positions();
    join_over_edges(looks, task);
    number_corners();
    fit(task);
  }

 private:
  struct Edge {
    std::uint32_t low, high;  ///< positions
    std::uint32_t leaf;
    std::uint8_t low_corner, high_corner;
    auto operator<=>(const Edge&) const = default;
  };

  const Node& node(std::size_t leaf) const { return elements_.nodes()[leaves_[leaf]]; }
  const Vec3& normal(std::size_t leaf) const { return elements_.element_of(leaves_[leaf]).normal; }
  static std::uint32_t place(std::uint32_t leaf, std::size_t corner) {
    return static_cast<std::uint32_t>(leaf * child_count + corner);
  }

  /// Equal positions have equal numbers: neighbours halve the same edge in the same way, to the bit.
  void number_positions() {
    struct Corner {
      std::array<std::uint32_t, 3> position;
      std::uint32_t place;
      auto operator<=>(const Corner&) const = default;
    };
    std::vector<Corner> sorted;
    for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf)
      for (std::size_t c = 0; c < child_count; ++c) sorted.push_back({bits_of(node(leaf).patch.corners[c]), place(leaf, c)});
    std::sort(sorted.begin(), sorted.end());
    position_.resize(sorted.size());
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i > 0 && sorted[i].position != sorted[i - 1].position) ++number;
      position_[sorted[i].place] = number;
    }
  }

  std::vector<Edge> sorted_edges() const {
    std::vector<Edge> edges;
    for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf) {
      if (result_.is_used_[leaf] == 0) continue;
      const std::size_t count = node(leaf).patch.corner_count();
      for (std::size_t c = 0; c < count; ++c) {
        const std::size_t d = (c + 1) % count;
        const std::uint32_t from = position_[place(leaf, c)], to = position_[place(leaf, d)];
        if (from != to)
          edges.push_back({std::min(from, to), std::max(from, to), leaf, static_cast<std::uint8_t>(from < to ? c : d),
                           static_cast<std::uint8_t>(from < to ? d : c)});
      }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  void join_over_edges(bool looks, Task& task) {
    const std::vector<Edge> edges = sorted_edges();
    std::vector<std::array<std::uint32_t, 2>> pairs;  // of edges
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      for (std::uint32_t j = i + 1; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high; ++j)
        if (glm::dot(normal(edges[i].leaf), normal(edges[j].leaf)) >= least_cosine) pairs.push_back({i, j});
    std::vector<std::uint8_t> parted(pairs.size(), 0);
    task.parallel_chunks(looks ? pairs.size() : 0, edge_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world_);
      for (std::size_t p = range.begin; p < range.end; ++p)
        parted[p] = is_parted(edges[pairs[p][0]].leaf, edges[pairs[p][1]].leaf, rays) ? 1 : 0;
    });
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (parted[p] != 0) continue;
      const Edge &a = edges[pairs[p][0]], &b = edges[pairs[p][1]];
      joined_.join(place(a.leaf, a.low_corner), place(b.leaf, b.low_corner));
      joined_.join(place(a.leaf, a.high_corner), place(b.leaf, b.high_corner));
    }
  }

  bool is_parted(std::uint32_t a, std::uint32_t b, RayStream& rays) const {
    const auto above = [&](std::uint32_t leaf) {
      return node(leaf).patch.middle() + raised * std::sqrt(node(leaf).patch.area()) * normal(leaf);
    };
    const Vec3 from = above(a);
    return rays.occluded({from, 0.0F, above(b) - from, 1.0F});
  }

  void number_corners() {
    std::vector<std::uint32_t> number(joined_count(), none);
    result_.corners_of_leaf_.resize(leaves_.size());
    for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf)
      for (std::size_t c = 0; c < child_count; ++c) {
        const std::size_t own = std::min(c, node(leaf).patch.corner_count() - 1);
        std::uint32_t& of_set = number[joined_.find(place(leaf, own))];
        if (of_set == none) {
          of_set = static_cast<std::uint32_t>(corner_positions_.size());
          corner_positions_.push_back(node(leaf).patch.corners[own]);
          corner_normals_.push_back(normal(leaf));
        }
        result_.corners_of_leaf_[leaf][c] = of_set;
      }
  }
  std::size_t joined_count() const { return leaves_.size() * child_count; }

  void fit(Task& task) {
    std::vector<std::uint32_t> corner_of_place, leaf_of_place;
    for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf)
      for (std::size_t c = 0; c < node(leaf).patch.corner_count() && result_.is_used_[leaf] != 0; ++c) {
        corner_of_place.push_back(result_.corners_of_leaf_[leaf][c]);
        leaf_of_place.push_back(leaf);
      }
    const Grouped around(corner_of_place, corner_positions_.size());
    std::vector<std::vector<Weight>> rows(corner_positions_.size());
    task.parallel_chunks(rows.size(), corner_chunk, [&](const ChunkRange& range) {
      for (auto corner = static_cast<std::uint32_t>(range.begin); corner < range.end; ++corner) {
        std::vector<std::uint32_t> first, second;
        for (const std::uint32_t place : around.of(corner)) first.push_back(leaf_of_place[place]);
        for (const std::uint32_t leaf : first)
          for (const std::uint32_t other : result_.corners_of_leaf_[leaf])
            for (const std::uint32_t place : around.of(other)) second.push_back(leaf_of_place[place]);
        std::sort(second.begin(), second.end());
        second.erase(std::unique(second.begin(), second.end()), second.end());
        rows[corner] = fitted(corner, first, second);
      }
    });
    result_.row_begin_.assign(1, 0);
    for (const std::vector<Weight>& row : rows) {
      result_.weights_.insert(result_.weights_.end(), row.begin(), row.end());
      result_.row_begin_.push_back(static_cast<std::uint32_t>(result_.weights_.size()));
    }
  }

  /// Moments of leaves about a corner, in its plane and in units of their size, weighted by area and nearness.
  struct Moments {
    double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    double determinant() const { return w * (xx * yy - xy * xy) - x * (x * yy - xy * y) + y * (x * xy - xx * y); }
    /// Of the plane's value at the corner, for a leaf at (px, py) of weight one.
    double share(double px, double py) const {
      return ((xx * yy - xy * xy) - px * (x * yy - xy * y) + py * (x * xy - xx * y)) / determinant();
    }
  };

  /// The leaves around the corner alone where they surround it; else the plane through those, and what lies beyond them, too.
  std::vector<Weight> fitted(std::uint32_t corner, const std::vector<std::uint32_t>& first,
                             const std::vector<std::uint32_t>& second) const {
    if (first.empty()) return {};
    float size = 0.0F;
    for (const std::uint32_t leaf : first) size += std::sqrt(node(leaf).patch.area()) / static_cast<float>(first.size());
    const Frame frame(corner_normals_[corner]);
    struct Seen {
      std::uint32_t leaf;
      double x, y, w;
    };
    const auto look = [&](const std::vector<std::uint32_t>& leaves, Moments& m) {
      std::vector<Seen> seen;
      for (const std::uint32_t leaf : leaves) {
        const Vec3 at = frame.to_local(node(leaf).patch.middle() - corner_positions_[corner]) / size;
        const double x = static_cast<double>(at.x), y = static_cast<double>(at.y), near = 0.25 + x * x + y * y;
        const double w = static_cast<double>(node(leaf).area) / (static_cast<double>(size * size) * near * near);
        seen.push_back({leaf, x, y, w});
        m.w += w, m.x += w * x, m.y += w * y, m.xx += w * x * x, m.xy += w * x * y, m.yy += w * y * y;
      }
      return seen;
    };
    Moments near, wide;
    std::vector<Seen> seen = look(first, near);
    const bool surrounded =
        first.size() >= 3 && std::hypot(near.x, near.y) < 0.1 * near.w && near.determinant() > 1e-6 * near.w * near.w * near.w;
    if (!surrounded) seen = look(second, wide);
    const Moments& m = surrounded ? near : wide;
    const bool plane = m.determinant() > 1e-4 * m.w * m.w * m.w;
    std::vector<Weight> row;
    for (const Seen& one : seen)
      row.push_back({one.leaf, static_cast<float>(plane ? one.w * m.share(one.x, one.y) : one.w / m.w)});
    return row;
  }

  const World& world_;
  const Elements& elements_;
  Reconstruction& result_;
  std::span<const std::uint32_t> leaves_;
  std::vector<std::uint32_t> position_;  ///< of corner c of leaf l at 4 l + c
  DisjointSets joined_;
  std::vector<Vec3> corner_positions_, corner_normals_;
};

Reconstruction::Reconstruction(const World& world, const Elements& elements, bool looks, Task& task) {
  Maker(world, elements, looks, task, *this);
}

std::vector<Rgb> Reconstruction::corner_values(std::span<const Rgb> leaf_means) const {
  std::vector<Rgb> values(corners());
  for (std::size_t corner = 0; corner < values.size(); ++corner)
    for (std::uint32_t i = row_begin_[corner]; i < row_begin_[corner + 1]; ++i)
      values[corner] += leaf_means[weights_[i].leaf] * weights_[i].share;
  for (int round = 0; round < corrections; ++round) add_what_lacks(leaf_means, values);
  return values;
}

void Reconstruction::add_what_lacks(std::span<const Rgb> leaf_means, std::vector<Rgb>& values) const {
  std::vector<Rgb> change(values.size());
  std::vector<float> leaves(values.size(), 0.0F);
  for (std::size_t leaf = 0; leaf < leaf_means.size(); ++leaf) {
    if (is_used_[leaf] == 0) continue;
    const auto& all = corners_of_leaf_[leaf];
    const std::span corners = std::span(all).first(all[3] == all[2] ? 3 : 4);
    Rgb sum;
    for (const std::uint32_t corner : corners) sum += values[corner];
    for (const std::uint32_t corner : corners) {
      change[corner] += leaf_means[leaf] - sum / static_cast<float>(corners.size());
      leaves[corner] += 1.0F;
    }
  }
  for (std::size_t corner = 0; corner < values.size(); ++corner)
    if (leaves[corner] > 0.0F) values[corner] += change[corner] / leaves[corner];
}

Rgb Reconstruction::at(const Elements& elements, std::span<const Rgb> values, std::uint32_t leaf_node, const Vec3& point) const {
  const Patch& patch = elements.nodes()[leaf_node].patch;
  const auto& corners = corners_of_leaf_[elements.leaf_of(leaf_node)];
  if (patch.is_quad()) {
    const Vec2 u = inverse_bilinear(patch, point);
    return (values[corners[0]] * (1.0F - u.x) + values[corners[1]] * u.x) * (1.0F - u.y) +
           (values[corners[3]] * (1.0F - u.x) + values[corners[2]] * u.x) * u.y;
  }
  const auto& [a, b, c, d] = patch.corners;
  const Vec3 normal = glm::cross(b - a, c - a);
  const float squared = glm::dot(normal, normal);
  if (!(squared > 0.0F)) return values[corners[0]];
  const float second = std::clamp(glm::dot(glm::cross(point - a, c - a), normal) / squared, 0.0F, 1.0F),
              third = std::clamp(glm::dot(glm::cross(b - a, point - a), normal) / squared, 0.0F, 1.0F - second);
  return values[corners[0]] * (1.0F - second - third) + values[corners[1]] * second + values[corners[2]] * third;
}

std::size_t Reconstruction::bytes() const {
  return corners_of_leaf_.capacity() * sizeof(corners_of_leaf_[0]) + row_begin_.capacity() * sizeof(std::uint32_t) +
         weights_.capacity() * sizeof(Weight) + is_used_.capacity();
}

}  // namespace gibench::wavelet
