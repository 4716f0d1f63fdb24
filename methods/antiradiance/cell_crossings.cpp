#include "methods/antiradiance/cell_crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gibench::antiradiance {

namespace {

constexpr float alike = 0.95F;           // cosine of normals between which a segment runs along the surface, not through it
constexpr std::size_t point_stride = 4;  // of a cell's points that are looked at from behind

float squared_distance(const CellPoint& point, const Vec3& to) {
  const Vec3 d = point.origin - to;
  return glm::dot(d, d);
}

/// Points joined to groups, each known by one of them.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) const {
    while (parents_[i] != i) i = parents_[i];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

bool nothing_between(const World& world, const CellPoint& from, const CellPoint& to, std::span<const std::uint32_t> faces,
                     RayStream& rays) {
  if (glm::dot(from.normal, to.normal) < alike) return true;
  const Vec3 way = to.origin - from.origin;
  if (!(glm::dot(way, way) > 0.0F)) return true;
  const Hit hit = rays.closest_hit({from.origin, 0.0F, way, 1.0F});
  // Between points of a curved surface the segment dips into it.
  return !hit || std::fabs(glm::dot(world.normal(hit.triangle), from.normal)) >= alike ||
         std::find(faces.begin(), faces.end(), world.scene().triangle_face[hit.triangle]) != faces.end();
}

bool part_cell(const World& world, std::span<CellPoint> points, std::span<const CellPoint> beside_vertex,
               std::span<const std::uint32_t> faces, RayStream& rays) {
  std::vector<std::size_t> exposed;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].exposed) exposed.push_back(k);
  if (exposed.size() < 2) return false;
  Groups groups(points.size());
  bool whole = true;
  for (std::size_t i = 1; i < exposed.size(); ++i) {
    if (nothing_between(world, points[exposed[i - 1]], points[exposed[i]], faces, rays)) groups.join(exposed[i - 1], exposed[i]);
    else whole = false;
  }
  if (whole) return false;
  for (std::size_t i = 0; i < exposed.size(); ++i)
    for (std::size_t j = i + 2; j < exposed.size(); ++j)
      if (groups.of(exposed[i]) != groups.of(exposed[j]) &&
          nothing_between(world, points[exposed[i]], points[exposed[j]], faces, rays))
        groups.join(exposed[i], exposed[j]);
  // By a point nearest to the vertex alone the cell might be taken for what lies beyond.
  std::sort(exposed.begin(), exposed.end(), [&](std::size_t a, std::size_t b) {
    const Vec3& vertex = beside_vertex.front().origin;
    const float da = squared_distance(points[a], vertex), db = squared_distance(points[b], vertex);
    return da != db ? da < db : a < b;
  });
  std::size_t kept = exposed.front();
  for (const CellPoint& start : beside_vertex) {
    const auto seen = std::find_if(exposed.begin(), exposed.end(),
                                   [&](std::size_t k) { return nothing_between(world, start, points[k], faces, rays); });
    if (seen == exposed.end()) continue;
    kept = *seen;
    break;
  }
  bool parted = false;
  for (const std::size_t k : exposed)
    if (groups.of(k) != groups.of(kept)) points[k].exposed = false, parted = true;
  return parted;
}

bool backed_within(std::span<const CellPoint> points, float distance, RayStream& rays) {
  for (std::size_t k = 0; k < points.size(); k += point_stride)
    if (points[k].exposed && rays.closest_hit({points[k].behind, 0.0F, -points[k].normal, distance})) return true;
  return false;
}

}  // namespace gibench::antiradiance
