#include "common/geometry/face_subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>

#include "common/core/error.h"
#include "common/geometry/convex_quad.h"
#include "common/geometry/mesh_topology.h"

namespace gibench {

namespace {

constexpr double count_slack = 1e-4;  // of a piece: what rounding may add to an edge of exactly n pieces
constexpr std::uint32_t most_pieces = 1U << 16;

using Chain = std::vector<std::uint32_t>;  // points along a side, both ends included

/// A face that is cut as a whole: a quad, or one of the scene's triangles (which repeats its third corner).
struct Patch {
  Face corners;  // points
  std::uint32_t first_triangle;
};

struct Edge {
  std::uint32_t low, high;         // points
  std::uint32_t interior_begin{};  // points from here on, from low to high
};

class ObjectCutter {
 public:
  ObjectCutter(const World& world, std::uint32_t object, double edge_length, float weld)
      : world_(world), object_(world.scene().objects[object]), edge_length_(edge_length) {
    weld_corners(weld);
    collect_patches();
    count_pieces();
  }

  SubdividedObject cut() {
    for (const Patch& patch : patches_) {
      const std::size_t before = result_.faces.size();
      if (patch.corners.is_quad()) cut_quad(patch);
      else if (stays_whole(patch)) result_.faces.push_back(patch.corners);
      else cut_triangle(side(patch, 0), side(patch, 1), side(patch, 2));
      result_.first_triangle.resize(result_.faces.size(), patch.first_triangle);
      result_.triangle_count.resize(result_.faces.size(), patch.corners.is_quad() ? 2 : 1);
      GIBENCH_CHECK(result_.faces.size() > before, "every face with area is cut into one at least");
    }
    return std::move(result_);
  }

 private:
  Vec3d& point(std::uint32_t p) { return result_.points[p]; }
  std::uint32_t add_point(const Vec3d& position) {
    result_.points.push_back(position);
    return static_cast<std::uint32_t>(result_.points.size() - 1);
  }
  double length(std::uint32_t a, std::uint32_t b) { return glm::length(point(b) - point(a)); }

  void weld_corners(float tolerance) {
    const std::span<const Vec3> own =
        std::span(world_.scene().vertices).subspan(object_.vertex_begin, object_.vertex_end - object_.vertex_begin);
    const std::vector<std::uint32_t> weld = weld_vertices(own, tolerance);
    corner_point_.resize(own.size());
    for (std::uint32_t v = 0; v < own.size(); ++v)
      if (weld[v] == v) corner_point_[v] = add_point(Vec3d(own[v]));
    for (std::uint32_t v = 0; v < own.size(); ++v) corner_point_[v] = corner_point_[weld[v]];
  }

  /// The points of a face; points of its own where welding would let it collapse.
  Face points_of(const Face& face) {
    Face points;
    const std::size_t corners = face.is_quad() ? 4 : 3;
    for (std::size_t i = 0; i < corners; ++i) points.corners[i] = corner_point_[face.corners[i] - object_.vertex_begin];
    for (std::size_t i = 0; i < corners; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (points.corners[i] == points.corners[j]) return unwelded(face, corners);
    if (corners == 4) return points;
    points.corners[3] = points.corners[2];
    return keeps_area(face, points) ? points : unwelded(face, corners);
  }
  /// A sliver thinner than the welding may be left without area.
  bool keeps_area(const Face& face, const Face& points) {
    const auto doubled = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) { return glm::length(glm::cross(b - a, c - a)); };
    const auto& v = world_.scene().vertices;
    const auto& [a, b, c, d] = face.corners;
    const auto& [p, q, r, s] = points.corners;
    return doubled(point(p), point(q), point(r)) > 0.5 * doubled(Vec3d(v[a]), Vec3d(v[b]), Vec3d(v[c]));
  }
  Face unwelded(const Face& face, std::size_t corners) {
    Face points;
    for (std::size_t i = 0; i < corners; ++i) points.corners[i] = add_point(Vec3d(world_.scene().vertices[face.corners[i]]));
    if (corners == 3) points.corners[3] = points.corners[2];
    return points;
  }

  bool is_cut_as_a_quad(const Face& quad) const {
    std::array<Vec3d, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = Vec3d(world_.scene().vertices[quad.corners[i]]);
    return is_planar_and_convex(corners);
  }

  void collect_patches() {
    const Scene& scene = world_.scene();
    for (std::uint32_t t = object_.triangle_begin; t < object_.triangle_end; ++t) {
      const Face& face = scene.faces[scene.triangle_face[t]];
      const bool first_of_quad =
          face.is_quad() && t + 1 < object_.triangle_end && scene.triangle_face[t + 1] == scene.triangle_face[t];
      if (first_of_quad && world_.area(t) > 0.0F && world_.area(t + 1) > 0.0F && is_cut_as_a_quad(face)) {
        patches_.push_back({points_of(face), t});
        ++t;
        continue;
      }
      const auto& [a, b, c] = scene.triangles[t].corners;
      if (world_.area(t) > 0.0F) patches_.push_back({points_of({{a, b, c, c}}), t});
    }
  }

  /// A triangle none of whose sides is cut; where there are quads, these may cut sides that are short enough.
  bool stays_whole(const Patch& patch) {
    if (has_quads_ || patch.corners.is_quad()) return false;
    const auto& [a, b, c, d] = patch.corners.corners;
    return pieces_of(length(a, b)) == 1 && pieces_of(length(b, c)) == 1 && pieces_of(length(c, a)) == 1;
  }

  /// Sides are cut into as many pieces as their length asks for, and opposite sides of quads into as many as the longer.
  void count_pieces() {
    has_quads_ = std::any_of(patches_.begin(), patches_.end(), [](const Patch& patch) { return patch.corners.is_quad(); });
    for (const Patch& patch : patches_) {
      if (stays_whole(patch)) continue;
      const std::size_t corners = patch.corners.is_quad() ? 4 : 3;
      std::array<std::uint32_t, 4> sides{};
      for (std::size_t i = 0; i < corners; ++i)
        sides[i] = edge_of(patch.corners.corners[i], patch.corners.corners[(i + 1) % corners]);
      if (corners == 4) join(sides[0], sides[2]), join(sides[1], sides[3]);
    }
    pieces_.assign(edges_.size(), 1);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      std::uint32_t& most = pieces_[root(e)];
      most = std::max(most, pieces_of(length(edges_[e].low, edges_[e].high)));
    }
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      pieces_[e] = pieces_[root(e)];
      edges_[e].interior_begin = add_between(edges_[e].low, edges_[e].high, pieces_[e]);
    }
  }

  std::uint32_t pieces_of(double length) const {
    const double wanted = std::ceil(length / edge_length_ - count_slack);
    return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, static_cast<double>(most_pieces)));
  }

  std::uint32_t add_between(std::uint32_t from, std::uint32_t to, std::uint32_t pieces) {
    const auto begin = static_cast<std::uint32_t>(result_.points.size());
    for (std::uint32_t i = 1; i < pieces; ++i) add_point(glm::mix(point(from), point(to), static_cast<double>(i) / pieces));
    return begin;
  }

  std::uint32_t edge_of(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
    const auto [found, added] = edge_index_.try_emplace(key, static_cast<std::uint32_t>(edges_.size()));
    if (added) {
      edges_.push_back({std::min(a, b), std::max(a, b)});
      parent_.push_back(found->second);
    }
    return found->second;
  }
  std::uint32_t root(std::uint32_t e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

  Chain side(const Patch& patch, std::size_t i) {
    const std::size_t corners = patch.corners.is_quad() ? 4 : 3;
    const std::uint32_t from = patch.corners.corners[i], to = patch.corners.corners[(i + 1) % corners];
    const std::uint32_t e = edge_of(from, to);
    return chain(edges_[e].low, edges_[e].interior_begin, pieces_[e], edges_[e].high, from != edges_[e].low);
  }
  static Chain chain(std::uint32_t from, std::uint32_t interior, std::uint32_t pieces, std::uint32_t to, bool backward = false) {
    Chain points(pieces + 1);
    std::iota(points.begin() + 1, points.end() - 1, interior);
    points.front() = from;
    points.back() = to;
    if (backward) std::reverse(points.begin(), points.end());
    return points;
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { result_.faces.push_back({{a, b, c, c}}); }

  void cut_quad(const Patch& patch) {
    Chain bottom = side(patch, 0), right = side(patch, 1), top = side(patch, 2), left = side(patch, 3);
    std::reverse(top.begin(), top.end());
    std::reverse(left.begin(), left.end());
    const auto& [a, b, c, d] = patch.corners.corners;
    const Vec3d pa = point(a), pb = point(b), pc = point(c), pd = point(d);
    const std::size_t columns = bottom.size() - 1, rows = left.size() - 1;
    std::vector<Chain> grid(rows + 1, Chain(columns + 1));
    for (std::size_t j = 0; j <= rows; ++j)
      for (std::size_t i = 0; i <= columns; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(columns),
                     t = static_cast<double>(j) / static_cast<double>(rows);
        grid[j][i] = j == 0         ? bottom[i]
                     : j == rows    ? top[i]
                     : i == 0       ? left[j]
                     : i == columns ? right[j]
                                    : add_point(glm::mix(glm::mix(pa, pb, s), glm::mix(pd, pc, s), t));
      }
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i)
        result_.faces.push_back({{grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]}});
  }

  /// Sides run from the first corner to the second, to the third, and back.
  void cut_triangle(Chain ab, Chain bc, Chain ca) {
    if (ab.size() == bc.size() && bc.size() == ca.size()) {
      cut_evenly(ab, bc, ca);
      return;
    }
    while (!is_longest_cut(ab, bc, ca)) {
      std::swap(ab, bc);
      std::swap(bc, ca);
    }
    const std::size_t middle = (ab.size() - 1) / 2;
    const std::uint32_t across = pieces_of(length(ab[middle], ca.front()));
    const std::uint32_t interior = add_between(ab[middle], ca.front(), across);
    const Chain down = chain(ab[middle], interior, across, ca.front());
    const auto split = ab.begin() + static_cast<std::ptrdiff_t>(middle);
    cut_triangle(Chain(ab.begin(), split + 1), down, ca);
    cut_triangle(Chain(split, ab.end()), bc, Chain(down.rbegin(), down.rend()));
  }
  double cut_length(const Chain& side) { return side.size() > 2 ? length(side.front(), side.back()) : -1.0; }
  bool is_longest_cut(const Chain& first, const Chain& second, const Chain& third) {
    return cut_length(first) >= std::max(cut_length(second), cut_length(third));
  }

  void cut_evenly(const Chain& ab, const Chain& bc, const Chain& ca) {
    const std::size_t pieces = ab.size() - 1;
    Chain above{ab.front()};
    for (std::size_t row = 1; row <= pieces; ++row) {
      const std::uint32_t left = ab[row], right = ca[pieces - row];
      Chain below{left};
      for (std::size_t i = 1; i < row; ++i)
        below.push_back(row == pieces
                            ? bc[i]
                            : add_point(glm::mix(point(left), point(right), static_cast<double>(i) / static_cast<double>(row))));
      below.push_back(right);
      for (std::size_t i = 0; i < row; ++i) {
        add_triangle(above[i], below[i], below[i + 1]);
        if (i + 1 < row) add_triangle(above[i], below[i + 1], above[i + 1]);
      }
      above = std::move(below);
    }
  }

  const World& world_;
  const Object& object_;
  double edge_length_;
  SubdividedObject result_;
  std::vector<std::uint32_t> corner_point_;  // of every vertex of the object
  std::vector<Patch> patches_;
  bool has_quads_ = false;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> pieces_, parent_;  // of every edge
  std::unordered_map<std::uint64_t, std::uint32_t> edge_index_;
};

}  // namespace

SubdividedObject subdivide_object(const World& world, std::uint32_t object, double edge_length, float weld) {
  GIBENCH_CHECK(edge_length > 0.0, "an edge length is above zero");
  return ObjectCutter(world, object, edge_length, weld).cut();
}

}  // namespace gibench
