#include "common/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numeric>

namespace gibench {

namespace {

using Vec2d = glm::dvec2;

/// Twice the signed area of a triangle in the plane.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The polygon in the coordinate plane that it covers most of, counter-clockwise.
std::vector<Vec2d> flattened(std::span<const Vec3d> corners) {
  Vec3d area(0.0);  // vector area (Newell's method)
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(area[i]) > std::fabs(area[axis])) axis = i;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (area[axis] < 0.0) std::swap(u, v);
  std::vector<Vec2d> flat;
  for (const Vec3d& corner : corners) flat.emplace_back(corner[u], corner[v]);
  return flat;
}

/// Clips the corners of a polygon one by one.
class EarClipping {
 public:
  explicit EarClipping(std::vector<Vec2d> corners)
      : corners_(std::move(corners)), left_(corners_.size()), ears_(corners_.size()) {
    std::iota(left_.begin(), left_.end(), 0U);
    look_for_ears();
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    while (left_.size() > 3) clip(next_ear());
    clip(1);
    return triangles_;
  }

 private:
  std::array<std::uint32_t, 3> around(std::size_t i) const {
    return {left_[(i + left_.size() - 1) % left_.size()], left_[i], left_[(i + 1) % left_.size()]};
  }

  double turn_at(std::size_t i) const {
    const auto [a, b, c] = around(i);
    return turn(corners_[a], corners_[b], corners_[c]);
  }

  /// A convex corner whose triangle holds no other corner, also not on its border.
  bool is_ear(std::size_t i) const {
    if (!(turn_at(i) > 0.0)) return false;
    const auto [ia, ib, ic] = around(i);
    const Vec2d a = corners_[ia], b = corners_[ib], c = corners_[ic];
    for (const std::uint32_t other : left_) {
      const Vec2d p = corners_[other];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  void look_for_ears() {
    for (std::size_t i = 0; i < left_.size(); ++i) ears_[i] = is_ear(i);
  }

  /// An ear; in a polygon that is not simple a straight corner, or any.
  std::size_t next_ear() {
    auto ear = std::find(ears_.begin(), ears_.end(), true);
    if (ear == ears_.end() && is_simple_) {  // corners on the border of others were clipped
      look_for_ears();
      ear = std::find(ears_.begin(), ears_.end(), true);
      is_simple_ = ear != ears_.end();
    }
    if (ear != ears_.end()) return static_cast<std::size_t>(ear - ears_.begin());
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (turn_at(i) == 0.0) return i;
    return 1;
  }

  /// In a simple polygon that changes only whether the two neighbours are ears (Meisters 1975); looking at all corners
  /// again would take the cube of their number.
  void clip(std::size_t i) {
    triangles_.push_back(around(i));
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
    ears_.erase(ears_.begin() + static_cast<std::ptrdiff_t>(i));
    for (const std::size_t neighbour : {(i + left_.size() - 1) % left_.size(), i % left_.size()})
      ears_[neighbour] = is_ear(neighbour);
  }

  std::vector<Vec2d> corners_;
  std::vector<std::uint32_t> left_;
  std::vector<bool> ears_;  // of those left
  bool is_simple_ = true;   // as far as is known
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(std::span<const Vec3d> corners) {
  return EarClipping(flattened(corners)).run();
}

}  // namespace gibench
