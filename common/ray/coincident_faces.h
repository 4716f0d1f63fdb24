/// Triangles of a scene that coincide: which of them is in front, by a rule that does not depend on their order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"
#include "common/ray/coplanar_pairs.h"
#include "common/ray/ray.h"
#include "common/scene/scene.h"

namespace gibench {

/// How many pairs of triangles coincide.
struct CoincidenceCounts {
  std::size_t twins = 0;           ///< the same corners and winding: one surface
  std::size_t opposite_twins = 0;  ///< the same corners, opposite winding: a two-sided pair
  std::size_t overlaps = 0;        ///< in one plane, in part
};

CoincidenceCounts count_coincidences(std::span<const CoplanarPair> pairs);

/// Of the triangles that lie at one point, a ray meets the one that is lit from its side (a front, or either side of a
/// two-sided object) before a black back; then an emitter; then a front; then that of the object with less area (a rug lies
/// on a floor); then by the objects' names. Immutable, shared by all threads.
class CoincidentFaces {
 public:
  /// `pairs` are those of the scene's triangles; `normals` one for each triangle. Scene and normals must outlive this.
  CoincidentFaces(const Scene& scene, std::span<const Vec3> normals, std::span<const CoplanarPair> pairs);

  bool empty() const { return partners_.empty(); }
  /// Whether another triangle lies over any part of this.
  bool has_partners(std::uint32_t triangle) const { return !empty() && first_[triangle] != first_[triangle + 1]; }
  /// A twin of the same winding is in front of all of it, whatever side it is seen from: it counts no area.
  bool is_hidden(std::uint32_t triangle) const { return !empty() && hidden_[triangle] != 0; }

  /// What a ray of this direction meets where it meets `hit`.
  Hit in_front(const Hit& hit, const Vec3& direction) const {
    return hit && has_partners(hit.triangle) ? settled(hit, direction) : hit;
  }
  /// Whether a ray of this direction that meets this point of the triangle meets the triangle.
  bool shows(std::uint32_t triangle, float u, float v, const Vec3& direction) const {
    return in_front({triangle, u, v, 0.0F}, direction).triangle == triangle;
  }

 private:
  Hit settled(const Hit& hit, const Vec3& direction) const;
  std::span<const std::uint32_t> partners(std::uint32_t triangle) const {
    return std::span(partners_).subspan(first_[triangle], first_[triangle + 1] - first_[triangle]);
  }
  bool precedes(std::uint32_t a, std::uint32_t b, const Vec3& direction) const;
  void rank_objects();
  void find_hidden(std::span<const CoplanarPair> pairs);

  const Scene& scene_;
  std::span<const Vec3> normals_;
  // All of these are empty where nothing coincides.
  std::vector<std::uint32_t> first_;     ///< of a triangle's partners; one more than triangles
  std::vector<std::uint32_t> partners_;  ///< ascending in each run
  std::vector<std::uint8_t> hidden_;     ///< one for each triangle
  std::vector<std::uint32_t> rank_;      ///< of an object among all: what is in front has the lower
};

}  // namespace gibench
