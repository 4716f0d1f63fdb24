/// A scene made ready for transport: what it holds, and its shape made ready for rays.
#pragma once

#include <cstdint>
#include <memory>

#include "common/core/vec.h"
#include "common/ray/coincident_faces.h"
#include "common/ray/ray_backend.h"
#include "common/ray/world_geometry.h"
#include "common/scene/scene.h"

namespace gibench {

/// A point of a surface, seen from one side: where a method is asked for light.
struct SurfaceSample {
  Vec3 position;
  Vec3 normal;  ///< unit, on the side that is asked about
  std::uint32_t object = 0;
  std::uint32_t face = 0;      ///< index into Scene::faces
  std::uint32_t triangle = 0;  ///< index into Scene::triangles
  Vec2 barycentrics{0.0F};     ///< of the triangle's second and third corner
  bool lit_side = true;        ///< the front, or either side of a two-sided object; a back is black
};

/// A scene with its geometry, normals, areas and ray backend. It never changes: an edit makes another.
class World {
 public:
  /// `threads` build the geometry (0: all cores). The rays are Embree's.
  explicit World(Scene scene, int threads = 0);
  /// The rays are those of another backend.
  World(Scene scene, int threads, MakeRayBackend make_rays);
  /// The scene of `before` after an edit, with the same backend. Where no vertex and no triangle differs, as after edits of
  /// materials and lights, the two worlds share their geometry; each may outlive the other.
  World(Scene scene, const World& before);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const Scene& scene() const { return scene_; }
  const WorldGeometry& geometry() const { return *geometry_; }
  /// Where triangles coincide, hits are those of coincident().
  const RayBackend& rays() const { return settled_rays_ ? *settled_rays_ : geometry_->rays(); }
  const CoincidentFaces& coincident() const { return coincident_; }

  /// Unit front normal; zero for a degenerate triangle, which has area 0 and is never sampled.
  const Vec3& normal(std::uint32_t triangle) const { return geometry_->normal(triangle); }
  /// m², one side; 0 of a triangle that is hidden by its twin.
  float area(std::uint32_t triangle) const { return coincident_.is_hidden(triangle) ? 0.0F : geometry_->area(triangle); }
  double total_area() const { return total_area_; }  ///< m², one side of every triangle
  Vec3 bounds_min() const { return geometry_->bounds_min(); }
  Vec3 bounds_max() const { return geometry_->bounds_max(); }
  float diagonal() const { return glm::length(bounds_max() - bounds_min()); }  ///< metres, of the bounding box

  Vec3 position(std::uint32_t triangle, Vec2 barycentrics) const;
  /// The side of `triangle` that is seen from this direction (normal · direction ≥ 0 on the front).
  SurfaceSample sample_at(std::uint32_t triangle, Vec2 barycentrics, const Vec3& seen_from_direction) const;
  /// Where a ray of this direction hit.
  SurfaceSample sample_of_hit(const Hit& hit, const Vec3& ray_direction) const {
    return sample_at(hit.triangle, {hit.u, hit.v}, -ray_direction);
  }

  /// An origin just off the surface on the side of `sample.normal`, far enough that a ray from there does not
  /// meet the surface again, near enough for a crack of a few 1e-5 of the local coordinates.
  Vec3 ray_origin(const SurfaceSample& sample) const { return sample.position + offset(sample) * sample.normal; }
  /// The length of that offset, metres: from the rounding of the position and of the triangle's corners.
  float offset(const SurfaceSample& sample) const;

  /// The ray from `from` towards `to`, ending just short of the surface at `to`: for occlusion between two points.
  Ray segment(const SurfaceSample& from, const SurfaceSample& to) const;

 private:
  std::shared_ptr<const WorldGeometry> build_geometry() const;
  void settle();

  Scene scene_;
  int threads_ = 0;
  MakeRayBackend make_rays_;
  std::shared_ptr<const WorldGeometry> geometry_;
  CoincidentFaces coincident_;
  std::unique_ptr<const RayBackend> settled_rays_;  ///< none where nothing coincides
  double total_area_ = 0.0;
};

}  // namespace gibench
