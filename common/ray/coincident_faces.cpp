#include "common/ray/coincident_faces.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace gibench {

namespace {

constexpr double edge_margin = 1e-6;  // of the barycentrics: a point on a shared edge lies in both

Vec3d corner(const Scene& scene, std::uint32_t triangle, std::size_t i) {
  return Vec3d(scene.vertices[scene.triangles[triangle].corners[i]]);
}

/// The barycentrics of the point's foot on the triangle's plane, where it lies in the triangle.
std::optional<Vec2> barycentrics_within(const Scene& scene, std::uint32_t triangle, const Vec3d& point) {
  const Vec3d origin = corner(scene, triangle, 0);
  const Vec3d first = corner(scene, triangle, 1) - origin, second = corner(scene, triangle, 2) - origin;
  const Vec3d normal = glm::cross(first, second);
  const double squared = glm::dot(normal, normal);
  if (!(squared > 0.0)) return std::nullopt;
  const double u = glm::dot(glm::cross(point - origin, second), normal) / squared;
  const double v = glm::dot(glm::cross(first, point - origin), normal) / squared;
  if (!(u >= -edge_margin && v >= -edge_margin && u + v <= 1.0 + edge_margin)) return std::nullopt;
  return Vec2(static_cast<float>(u), static_cast<float>(v));
}

/// The same place on a triangle with the same corners keeps its barycentrics to the bit.
Vec3d position(const Scene& scene, const Hit& hit) {
  const Vec3d origin = corner(scene, hit.triangle, 0);
  return origin + static_cast<double>(hit.u) * (corner(scene, hit.triangle, 1) - origin) +
         static_cast<double>(hit.v) * (corner(scene, hit.triangle, 2) - origin);
}

/// m², of every object.
std::vector<double> areas_of_objects(const Scene& scene) {
  std::vector<double> areas(scene.objects.size(), 0.0);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const Vec3d origin = corner(scene, t, 0);
    areas[scene.triangle_object[t]] += 0.5 * glm::length(glm::cross(corner(scene, t, 1) - origin, corner(scene, t, 2) - origin));
  }
  return areas;
}

}  // namespace

CoincidenceCounts count_coincidences(std::span<const CoplanarPair> pairs) {
  CoincidenceCounts counts;
  for (const CoplanarPair& pair : pairs)
    ++(!pair.same_corners ? counts.overlaps : pair.same_winding ? counts.twins : counts.opposite_twins);
  return counts;
}

CoincidentFaces::CoincidentFaces(const Scene& scene, std::span<const Vec3> normals, std::span<const CoplanarPair> pairs)
    : scene_(scene), normals_(normals) {
  if (pairs.empty()) return;
  const std::size_t count = scene.triangles.size();
  first_.assign(count + 1, 0);
  for (const CoplanarPair& pair : pairs) ++first_[pair.a + 1], ++first_[pair.b + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  partners_.resize(2 * pairs.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const CoplanarPair& pair : pairs) partners_[next[pair.a]++] = pair.b, partners_[next[pair.b]++] = pair.a;
  rank_objects();
  find_hidden(pairs);
}

void CoincidentFaces::rank_objects() {
  const std::vector<double> areas = areas_of_objects(scene_);
  std::vector<std::uint32_t> order(scene_.objects.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(areas[a], scene_.objects[a].name) < std::tie(areas[b], scene_.objects[b].name);
  });
  rank_.resize(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
}

void CoincidentFaces::find_hidden(std::span<const CoplanarPair> pairs) {
  hidden_.assign(scene_.triangles.size(), 0);
  for (const CoplanarPair& pair : pairs) {
    if (!pair.same_corners || !pair.same_winding) continue;
    const Vec3& normal = normals_[pair.a];
    const bool from_front = precedes(pair.a, pair.b, -normal), from_back = precedes(pair.a, pair.b, normal);
    if (from_front == from_back) hidden_[from_front ? pair.b : pair.a] = 1;
  }
}

/// Whether a is in front of b for a ray of this direction; both lie at the point that it meets.
bool CoincidentFaces::precedes(std::uint32_t a, std::uint32_t b, const Vec3& direction) const {
  const auto order = [&](std::uint32_t triangle) {
    const Object& object = scene_.objects[scene_.triangle_object[triangle]];
    const bool front = glm::dot(normals_[triangle], direction) <= 0.0F;
    const bool lit = front || object.two_sided;
    const bool emits = !is_black(scene_.materials[object.material].emission);
    return std::tuple(!lit, !emits, !front, rank_[scene_.triangle_object[triangle]], triangle);
  };
  return order(a) < order(b);
}

Hit CoincidentFaces::settled(const Hit& hit, const Vec3& direction) const {
  Hit best = hit;
  const Vec3d point = position(scene_, hit);
  for (const std::uint32_t partner : partners(hit.triangle)) {
    if (!precedes(partner, best.triangle, direction)) continue;
    if (const auto at = barycentrics_within(scene_, partner, point)) best = {partner, at->x, at->y, hit.distance};
  }
  return best;
}

}  // namespace gibench
