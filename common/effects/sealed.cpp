#include "common/effects/sealed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "common/geometry/mesh_topology.h"

namespace gibench {

// The winding number of a closed, oriented surface about a point changes only where that surface is crossed and is zero
// far away. So a point with another number sees the surface in every direction, whatever else there is. A room is a
// component whose edges each join two faces that run along it in opposite ways, with one-sided fronts that face inwards
// (negative volume) and no two faces that cross: about the inner side of its faces the number is not zero. A component
// that crosses no face of the room lies inside or outside as a whole, as one of its points does.

namespace {

constexpr std::size_t most_triangles = 2048;
constexpr std::size_t most_pairs = std::size_t{1} << 22;  // of faces tested against one another for crossings
constexpr double contact = 1e-6;                          // of the scene's diagonal: nearer things touch

using Corners = std::array<Vec3d, 3>;

class Parts {
 public:
  explicit Parts(const World& world)
      : world_(world),
        scene_(world.scene()),
        weld_(weld_vertices(scene_.vertices, weld_tolerance(scene_.vertices))),
        tolerance_(contact * static_cast<double>(world.diagonal())) {
    for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t) {
      const auto& [a, b, c] = scene_.triangles[t].corners;
      if (weld_[a] != weld_[b] && weld_[b] != weld_[c] && weld_[c] != weld_[a]) triangles_.push_back(t);
    }
    find_components();
  }

  bool sealed() const {
    std::vector<std::size_t> rooms;
    for (std::size_t c = 0; c < components_.size(); ++c)
      if (is_room(c)) rooms.push_back(c);
    for (std::size_t c = 0; c < components_.size(); ++c) {
      const bool is_one = std::find(rooms.begin(), rooms.end(), c) != rooms.end();
      if (!is_one && std::none_of(rooms.begin(), rooms.end(), [&](std::size_t room) { return lies_inside(c, room); }))
        return false;
    }
    return !rooms.empty();
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void find_components() {
    std::map<Edge, std::vector<std::size_t>> at_edge;  // without direction
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (const auto& [a, b] : edges_of(i)) at_edge[{std::min(a, b), std::max(a, b)}].push_back(i);
    std::vector<std::size_t> root(triangles_.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    for (const auto& entry : at_edge)
      for (const std::size_t i : entry.second) root[find(i)] = find(entry.second.front());
    std::map<std::size_t, std::size_t> number;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const auto place = number.try_emplace(find(i), components_.size());
      if (place.second) components_.emplace_back();
      components_[place.first->second].push_back(i);
    }
  }

  std::array<Edge, 3> edges_of(std::size_t i) const {
    const auto& [a, b, c] = scene_.triangles[triangles_[i]].corners;
    return {{{weld_[a], weld_[b]}, {weld_[b], weld_[c]}, {weld_[c], weld_[a]}}};
  }
  Corners corners_of(std::size_t i) const {
    const auto& [a, b, c] = scene_.triangles[triangles_[i]].corners;
    return {Vec3d(scene_.vertices[a]), Vec3d(scene_.vertices[b]), Vec3d(scene_.vertices[c])};
  }
  bool two_sided(std::size_t i) const { return scene_.objects[scene_.triangle_object[triangles_[i]]].two_sided; }
  bool within_reach() const { return triangles_.size() * triangles_.size() <= most_pairs; }

  bool is_room(std::size_t component) const {
    std::map<Edge, int> uses;
    double volume = 0.0;
    for (const std::size_t i : components_[component]) {
      if (two_sided(i)) return false;
      for (const Edge& edge : edges_of(i)) ++uses[edge];
      const auto [a, b, c] = corners_of(i);
      volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    for (const auto& [edge, count] : uses)
      if (const auto back = uses.find({edge.second, edge.first}); count != 1 || back == uses.end() || back->second != 1)
        return false;
    return volume < 0.0 && (is_convex(component) || (within_reach() && !crosses_itself(component)));
  }

  /// All of the component in front of each of its faces.
  bool is_convex(std::size_t component) const {
    return std::all_of(components_[component].begin(), components_[component].end(),
                       [&](std::size_t face) { return lies_in_front(component, face); });
  }
  bool lies_in_front(std::size_t component, std::size_t face) const {
    for (const std::size_t i : components_[component])
      for (const Vec3d& corner : corners_of(i))
        if (height(face, corner) < -tolerance_) return false;
    return true;
  }
  double height(std::size_t face, const Vec3d& point) const {
    return glm::dot(Vec3d(world_.normal(triangles_[face])), point - corners_of(face)[0]);
  }

  bool straddles(std::size_t one, std::size_t plane) const {
    bool above = false, below = false;
    for (const Vec3d& corner : corners_of(one)) {
      const double h = height(plane, corner);
      above = above || h > tolerance_, below = below || h < -tolerance_;
    }
    return above && below;
  }
  bool boxes_meet(std::size_t one, std::size_t other) const {
    const auto [a, b, c] = corners_of(one);
    const auto [d, e, f] = corners_of(other);
    const Vec3d margin(tolerance_);
    const Vec3d low = glm::max(glm::min(a, glm::min(b, c)), glm::min(d, glm::min(e, f))) - margin;
    const Vec3d high = glm::min(glm::max(a, glm::max(b, c)), glm::max(d, glm::max(e, f))) + margin;
    return low.x <= high.x && low.y <= high.y && low.z <= high.z;
  }
  /// Two faces that do not straddle one another's plane do not cross; the others may.
  bool may_cross(std::size_t one, std::size_t other) const {
    return boxes_meet(one, other) && straddles(one, other) && straddles(other, one);
  }
  bool crosses_itself(std::size_t component) const {
    const auto& faces = components_[component];
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = i + 1; j < faces.size(); ++j)
        if (may_cross(faces[i], faces[j])) return true;
    return false;
  }

  /// A lit side that lies in a wall and faces out of the room.
  bool looks_out(std::size_t one, std::size_t wall) const {
    for (const Vec3d& corner : corners_of(one))
      if (std::fabs(height(wall, corner)) > tolerance_) return false;
    const double facing = glm::dot(Vec3d(world_.normal(triangles_[one])), Vec3d(world_.normal(triangles_[wall])));
    return (facing < 0.0 || two_sided(one)) && boxes_meet(one, wall);
  }

  bool lies_inside(std::size_t component, std::size_t room) const {
    const bool convex = is_convex(room);
    if (!convex && !within_reach()) return false;
    for (const std::size_t wall : components_[room]) {
      if (convex && !lies_in_front(component, wall)) return false;
      for (const std::size_t i : components_[component])
        if (looks_out(i, wall) || (!convex && may_cross(i, wall))) return false;
    }
    return convex || winding_number(room, inner_point(component)) != 0;
  }
  Vec3d inner_point(std::size_t component) const {
    const std::size_t i = components_[component].front();
    const auto [a, b, c] = corners_of(i);
    return (a + b + c) / 3.0 + tolerance_ * Vec3d(world_.normal(triangles_[i]));
  }

  /// Solid angles over 4π (Van Oosterom and Strackee 1983).
  int winding_number(std::size_t component, const Vec3d& point) const {
    double sum = 0.0;
    for (const std::size_t i : components_[component]) {
      auto [a, b, c] = corners_of(i);
      a -= point, b -= point, c -= point;
      const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                              la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(sum / (4.0 * pi_double)));
  }

  const World& world_;
  const Scene& scene_;
  std::vector<std::uint32_t> weld_;
  double tolerance_;
  std::vector<std::uint32_t> triangles_;              ///< those with three different corners
  std::vector<std::vector<std::size_t>> components_;  ///< places in triangles_
};

}  // namespace

bool is_sealed(const World& world) {
  const std::size_t count = world.scene().triangles.size();
  return count > 0 && count <= most_triangles && Parts(world).sealed();
}

}  // namespace gibench
