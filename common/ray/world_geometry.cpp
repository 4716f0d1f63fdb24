#include "common/ray/world_geometry.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace gibench {

namespace {

/// By their bits: == takes -0 for 0, and NaN for nothing.
template <class T>
bool have_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) == 3 * sizeof(std::uint32_t), "no bytes between the members");
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace

WorldGeometry::WorldGeometry(const Scene& scene, std::unique_ptr<const RayBackend> rays, int threads)
    : rays_(std::move(rays)), coplanar_(coplanar_pairs(scene.vertices, scene.triangles, threads)) {
  const std::size_t count = scene.triangles.size();
  normals_.resize(count);
  areas_.resize(count);
  extents_.resize(count);
  if (!scene.vertices.empty()) bounds_min_ = bounds_max_ = scene.vertices.front();
  for (const Vec3& v : scene.vertices) bounds_min_ = glm::min(bounds_min_, v), bounds_max_ = glm::max(bounds_max_, v);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b, c] = scene.triangles[i].corners;
    const Vec3d first = Vec3d(scene.vertices[b]) - Vec3d(scene.vertices[a]);
    const Vec3d second = Vec3d(scene.vertices[c]) - Vec3d(scene.vertices[a]);
    const Vec3d doubled = glm::cross(first, second);
    const double length = glm::length(doubled);
    areas_[i] = static_cast<float>(0.5 * length);
    normals_[i] = areas_[i] > 0.0F ? Vec3(doubled / length) : Vec3(0.0F);
    extents_[i] = std::max(max_abs(Vec3(first)), max_abs(Vec3(second)));
    total_area_ += 0.5 * length;
  }
  const std::vector<float> own = extents_;
  for (const CoplanarPair& pair : coplanar_) {
    extents_[pair.a] = std::max(extents_[pair.a], own[pair.b]);
    extents_[pair.b] = std::max(extents_[pair.b], own[pair.a]);
  }
}

bool have_same_shape(const Scene& a, const Scene& b) {
  return have_same_bits(a.vertices, b.vertices) && have_same_bits(a.triangles, b.triangles);
}

}  // namespace gibench
