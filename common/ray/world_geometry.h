/// The shape of a scene made ready for rays: the ray backend and the measures of every triangle.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/core/vec.h"
#include "common/ray/coplanar_pairs.h"
#include "common/ray/ray_backend.h"
#include "common/scene/scene.h"

namespace gibench {

/// What follows from vertices and triangles alone. Immutable, so that worlds of one shape share it whatever their materials
/// and lights are.
class WorldGeometry {
 public:
  /// `threads` look for coplanar triangles (0: all cores).
  WorldGeometry(const Scene& scene, std::unique_ptr<const RayBackend> rays, int threads);

  const RayBackend& rays() const { return *rays_; }
  /// Unit front normal; zero for a degenerate triangle.
  const Vec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  std::span<const Vec3> normals() const { return normals_; }
  float area(std::uint32_t triangle) const { return areas_[triangle]; }  ///< m², one side
  float extent(std::uint32_t triangle) const {
    return extents_[triangle];
  }  ///< metres, the largest coordinate of its edges and of those of triangles that overlap it in its plane
  double total_area() const { return total_area_; }  ///< m², one side of every triangle
  std::span<const CoplanarPair> coplanar() const { return coplanar_; }
  const Vec3& bounds_min() const { return bounds_min_; }
  const Vec3& bounds_max() const { return bounds_max_; }

 private:
  std::unique_ptr<const RayBackend> rays_;
  std::vector<Vec3> normals_;
  std::vector<float> areas_, extents_;
  double total_area_ = 0.0;
  std::vector<CoplanarPair> coplanar_;
  Vec3 bounds_min_{0.0F}, bounds_max_{0.0F};
};

/// Whether every vertex and every triangle of the two is the same, to the bit.
bool have_same_shape(const Scene& a, const Scene& b);

}  // namespace gibench
